//! The solver of absolute orientation that the parameters ask for.

use homolog_contract::parameters::OrientationSolver as Solver;
use homolog_registration::OrientationSolver;

/// The solver of registration for the parameter `named`.
pub(crate) fn solver(named: Solver) -> OrientationSolver {
    match named {
        Solver::Svd => OrientationSolver::Svd,
        Solver::Quaternion => OrientationSolver::Quaternion,
        Solver::OrthonormalMatrix => OrientationSolver::OrthonormalMatrix,
    }
}
