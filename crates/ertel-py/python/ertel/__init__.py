"""Film thickness, pressure, traction and temperature of elastohydrodynamic contacts.

A contact is a :class:`Case`; solving it gives a :class:`Result` (a :class:`Curve` where the case varies a quantity, a
:class:`MachineSolution` where it describes a whole machine, such as a :class:`Bearing`):

>>> import ertel
>>> case = ertel.Case.from_file("ball-on-disc.toml")   # doctest: +SKIP
>>> result = case.solve()                              # doctest: +SKIP
>>> result.film_central                                # doctest: +SKIP
249.38 ± 0.24 nm

Numbers are in SI. Bad input raises :class:`CaseError` with the words of the program, a solve that does not converge
:class:`ConvergenceError`, files that cannot be written or read
:class:`OutputError`. :func:`read` opens a folder of results.
"""

from ._case import Case, estimate, solve
from ._curve import Curve
from ._data import (
    FilmFit,
    Fit,
    Fluid,
    StribeckFit,
    explain,
    fit_density,
    fit_film,
    fit_stribeck,
    fit_viscosity,
    fluid,
    fluids,
    own_data,
    solids,
    viscosity,
)
from ._ertel import CaseError, ConvergenceError, OutputError, __version__
from ._laws import ErtelWarning, TabulatedLaw
from ._machine import ContactFigure, MachineContact, MachineFigure, MachineSolution, Shaft
from ._machines import Bearing, Cam, GearPair
from ._maps import write_map
from ._quantity import Quantity
from ._read import read
from ._result import Result
from ._studies import Comparison, Distribution, MonteCarlo, Study
from ._study import StudySummary, compare, merge, sweep
from ._transient import Instant, Transient

# The text of the error says how far the solve came, why it stopped, and what to try.
ConvergenceError.report = property(str)  # type: ignore[method-assign,assignment,misc]

__all__ = [
    "Bearing",
    "Cam",
    "Case",
    "CaseError",
    "Comparison",
    "ContactFigure",
    "ConvergenceError",
    "Curve",
    "Distribution",
    "ErtelWarning",
    "FilmFit",
    "Fit",
    "Fluid",
    "GearPair",
    "Instant",
    "MachineContact",
    "MachineFigure",
    "MachineSolution",
    "MonteCarlo",
    "OutputError",
    "Quantity",
    "Result",
    "Shaft",
    "StribeckFit",
    "Study",
    "StudySummary",
    "TabulatedLaw",
    "Transient",
    "__version__",
    "compare",
    "estimate",
    "explain",
    "fit_density",
    "fit_film",
    "fit_stribeck",
    "fit_viscosity",
    "fluid",
    "fluids",
    "merge",
    "own_data",
    "read",
    "solids",
    "solve",
    "sweep",
    "viscosity",
    "write_map",
]
