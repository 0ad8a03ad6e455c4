"""Makes reference.json: the same figures as homolog-study, by statsmodels, scipy and plain loops.

Run it with statsmodels 0.14 and scipy 1.16 or later; the test statistics.rs reads what it writes. The data are drawn here and
stored too, rounded, so that the test needs no Python."""
import json
import sys
import warnings

import numpy as np
import scipy
import statsmodels
import statsmodels.api as sm
from scipy import stats
from statsmodels.regression.mixed_linear_model import MixedLM
from statsmodels.stats.multitest import multipletests
from statsmodels.stats.power import TTestIndPower

warnings.simplefilter("ignore")
rng = np.random.default_rng(20)
n, v = 30, 7
group = (np.arange(n) % 3 == 0).astype(float)
age = np.round(rng.normal(65, 6, n), 3)
age_centered = age - age.mean()
X = np.column_stack([np.ones(n), group, age_centered])
# Unequal variances, so that robust errors differ from classical ones.
Y = np.round(rng.normal(size=(n, v)) * (1 + group)[:, None] + 0.4 * group[:, None] * np.arange(v) + 0.1 * age_centered[:, None], 6)
contrast = np.array([0.0, 1.0, 0.0])
out = {"made_with": f"statsmodels {statsmodels.__version__}, scipy {scipy.__version__}, numpy {np.__version__}"}
out["x"], out["y"] = X.tolist(), Y.tolist()

linear = []
for k in range(v):
    plain = sm.OLS(Y[:, k], X).fit()
    robust = sm.OLS(Y[:, k], X).fit(cov_type="HC3", use_t=True)
    test, rtest = plain.t_test(contrast), robust.t_test(contrast)
    linear.append({"effect": float(plain.params @ contrast), "t": float(test.tvalue.item()), "robust_se": float(rtest.sd.item()),
                   "robust_t": float(rtest.tvalue.item()), "robust_p": float(rtest.pvalue.item()),
                   "d": float(plain.params @ contrast / np.sqrt(plain.mse_resid))})
out["linear"] = linear
q = multipletests([row["robust_p"] for row in linear], method="fdr_bh")[1]
out["false_discovery"] = q.tolist()

# Freedman-Lane as its authors state it: fit the nuisance model, permute its residuals, add its fit, fit the full model.
Z = X[:, [0, 2]]
orders, maps = [np.arange(n)] + [rng.permutation(n) for _ in range(5)], []
for order in orders:
    t = []
    for k in range(v):
        nuisance = sm.OLS(Y[:, k], Z).fit()
        t.append(float(sm.OLS(nuisance.fittedvalues + nuisance.resid[order], X).fit().t_test(contrast).tvalue.item()))
    maps.append(t)
out["orders"], out["permuted_t"] = [o.tolist() for o in orders], maps

# Visits: 12 subjects with 1 to 4 of them.
people = np.repeat(np.arange(12), rng.integers(1, 5, 12))
m = len(people)
time = np.round(rng.uniform(0, 3, m), 3)
XV = np.column_stack([np.ones(m), (people % 2).astype(float), time])
YV = np.round(rng.normal(size=(12, 3))[people] * np.array([1.0, 0.3, 2.0]) + rng.normal(size=(m, 3)) + 0.3 * time[:, None], 6)
mixed = []
for k in range(3):
    fit = MixedLM(YV[:, k], XV, groups=people).fit(reml=True, method=["bfgs", "lbfgs"], gtol=1e-9)
    # Standard errors given the variances; those of statsmodels add the uncertainty of the variances in its own way.
    lam, effect = float(fit.cov_re[0, 0] / fit.scale), float(fit.fe_params[2])
    V = np.eye(m) + lam * (people[:, None] == people[None, :])
    se = float(np.sqrt(np.linalg.inv(XV.T @ np.linalg.solve(V, XV))[2, 2] * fit.scale))
    mixed.append({"effect": effect, "se": se, "between": lam / (1 + lam), "p": float(2 * stats.norm.sf(abs(effect / se)))})
out["visits"] = {"x": XV.tolist(), "y": YV.tolist(), "subjects": people.tolist(), "fits": mixed}

out["noncentral_t"] = [[t, nu, d, float(stats.nct.cdf(t, nu, d))] for t, nu, d in
                       [(0.5, 3, 1.0), (2.0, 10, 2.5), (-1.0, 57, 0.3), (3.5, 27, 3.0), (2.1, 500, 1.0), (0.0, 8, -1.2)]]
length = float(np.sqrt(1 / 20 + 1 / 30))
power = TTestIndPower()
out["power"] = [[d, 48, length, float(power.power(d, nobs1=20, ratio=1.5, alpha=0.05))] for d in (0.2, 0.5, 0.8, 1.2)]
out["needed"] = [[d, float(power.solve_power(d, power=0.8, alpha=0.05) * 2)] for d in (0.3, 0.5, 0.8)]
# The interval of d by quantiles of the noncentral t distribution.
intervals = []
for t, nu, ln in [(2.3, 58, 0.258), (-0.4, 28, 0.365), (5.1, 27, 0.4)]:
    ends = [scipy.optimize.brentq(lambda d: stats.nct.cdf(t, nu, d) - share, -15, 15) * ln for share in (0.975, 0.025)]
    intervals.append([t, nu, ln] + [float(e) for e in ends])
out["intervals"] = intervals
json.dump(out, open(sys.argv[1], "w"), separators=(",", ":"))
