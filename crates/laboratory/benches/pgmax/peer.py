"""PGMax on the energy that `ours.rs` exported: `peer.py DIR CORES ITERATIONS` prints a row of the table."""

import os
import resource
import sys
import time
from importlib.metadata import version
from pathlib import Path

DAMPING = 0.5


def main():
    folder, cores, iterations = Path(sys.argv[1]), int(sys.argv[2]), int(sys.argv[3])
    # Before JAX reads the number of cores.
    os.sched_setaffinity(0, sorted(os.sched_getaffinity(0))[:cores])
    os.environ["JAX_PLATFORMS"] = "cpu"
    import jax
    import numpy as np
    from pgmax import fgraph, fgroup, infer, vgroup
    from pgmax.infer.bp_state import BPArrays

    unary, edges, tables = (np.load(folder / f"{name}.npy") for name in ("unary", "edges", "tables"))
    variables = vgroup.NDVarArray(num_states=unary.shape[1], shape=(unary.shape[0],))
    graph = fgraph.FactorGraph(variable_groups=[variables])
    began = time.perf_counter()
    graph.add_factors(
        fgroup.PairwiseFactorGroup(
            variables_for_factors=[[variables[int(i)], variables[int(j)]] for i, j in edges],
            log_potential_matrix=-tables,
        )
    )
    propagation = infer.build_inferer(graph.bp_state, backend="bp")
    built = time.perf_counter() - began
    start = propagation.init(evidence_updates={variables: -unary})
    arrays = (start.log_potentials, start.ftov_msgs, start.evidence)

    def messages(potentials, messages, evidence):
        before = BPArrays(log_potentials=potentials, ftov_msgs=messages, evidence=evidence)
        return propagation.run(before, num_iters=iterations, damping=DAMPING, temperature=0.0).ftov_msgs

    run = jax.jit(messages).lower(*arrays).compile()
    # Once: its iterations are alike, and there are many.
    began = time.perf_counter()
    left = jax.block_until_ready(run(*arrays))
    taken = (time.perf_counter() - began) / iterations
    found = BPArrays(log_potentials=start.log_potentials, ftov_msgs=left, evidence=start.evidence)
    labeling = np.asarray(infer.decode_map_states(propagation.get_beliefs(found))[variables])
    # By the exported tables, as ours is by the model: PGMax counts no energy of its own here.
    sources, targets = edges.T
    energy = unary[np.arange(len(unary)), labeling].sum(dtype=np.float64)
    energy += tables[np.arange(len(edges)), labeling[sources], labeling[targets]].sum(dtype=np.float64)
    peak_mib = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    print(
        f"| PGMax {version('pgmax')}, JAX {jax.__version__} | {cores} | {taken * 1e3:.1f} | one run |"
        f" {peak_mib:.0f} | {energy:.1f} |"
    )
    print(f"built its graph in {built:.1f} s", file=sys.stderr)


if __name__ == "__main__":
    main()
