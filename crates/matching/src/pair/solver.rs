//! The solver of absolute orientation that the parameters name.

use homolog_contract::parameters::OrientationSolver as Solver;
use homolog_registration::OrientationSolver;

/// The solver that the parameters name, as registration calls it.
pub(crate) fn solver(named: Solver) -> OrientationSolver {
    match named {
        Solver::Svd => OrientationSolver::Svd,
        Solver::Quaternion => OrientationSolver::Quaternion,
        Solver::OrthonormalMatrix => OrientationSolver::OrthonormalMatrix,
    }
}
