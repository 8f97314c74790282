"""Rows of the table: errors, the order that they fall with, and whether the limit holds."""

import dataclasses
import math

ROUNDING = 1e-9  # below it there is no order to see


@dataclasses.dataclass
class Row:
    test: str
    source: str
    quantity: str
    exact: float
    measured: list      # one an accuracy, coarsest first
    scale: float        # what errors are relative to
    limit: float        # of the last
    reason: str = ""    # of a run that failed

    @property
    def errors(self):
        return [abs(x - self.exact) / abs(self.scale) for x in self.measured]

    @property
    def holds(self):
        return self.errors[-1] <= self.limit  # not of NaN

    def order(self, accuracies):
        """Of the time step, which goes as the root of the accuracy; NaN where there is none to see."""
        first, last = self.errors[0], self.errors[-1]
        if not (first > ROUNDING and last > ROUNDING and accuracies[0] > accuracies[-1]):
            return math.nan
        return 2 * math.log(first / last) / math.log(accuracies[0] / accuracies[-1])


def line(row, accuracies=None):
    errors = "  ".join(f"{error:8.1e}" for error in row.errors)
    order = "" if accuracies is None else "  " + ("   -" if math.isnan(row.order(accuracies)) else f"{row.order(accuracies):4.1f}")
    verdict = "holds" if row.holds else "off"
    out = f"{row.test:<52} {row.quantity:<26} {row.exact:15.9g}  {row.measured[-1]:15.9g}  {errors}{order}  {verdict:<5}"
    return (out + ("  " + row.source if accuracies is not None else "") + (f"  ({row.reason})" if row.reason else "")).rstrip()


def text(rows, missing, accuracies, commit):
    errors = "  ".join(f"{'at ' + format(a, 'g'):>8}" for a in accuracies)
    out = [f"commit {commit}", "command reports/verify/run",
           "Scenes against exact results. Errors are relative; order: of the time step, from the first to the last accuracy, - where an end is below 1e-9.",
           "holds: the last error is at most the row's limit, 1e-3.", "",
           f"{'test':<52} {'quantity':<26} {'exact':>15}  {'measured':>15}  {errors}  order", ""]
    out += [line(row, accuracies) for row in rows]
    out += ["", summary(rows), "", "Missing:"]
    out += [f"{test:<52} {why}" for test, why in missing]
    return "\n".join(out) + "\n"


def summary(rows):
    off = [row for row in rows if not row.holds]
    return f"{len(rows)} rows, {len(rows) - len(off)} hold, {len(off)} off"
