"""Chatter in milling: detection, stability lobes and modal analysis, as Stillcut does them.

All numbers are in SI units, but spindle speeds, which are in rpm as people and machines say them. Nothing here can
reach a machine. Errors in what is given are ValueError, with one line that says what, where and what to do.

    import stillcut
    answer = stillcut.analyze(x, 25600.0, teeth=4, speed=10100.0, sensor="sound")
    print(answer["answer"]["finding"])          # "chatter", "no-chatter" or "not-judged"
"""

from __future__ import annotations

import json
import operator
from dataclasses import dataclass, field
from typing import Any, Mapping, Sequence

import numpy
from numpy.typing import ArrayLike, NDArray

from . import _core

__all__ = ["Detector", "Fit", "Lobes", "Mode", "Verdict", "analyze", "detectors", "fit_modes", "lobes"]
__version__: str = _core.version

Settings = Mapping[str, object]


def detectors() -> list[str]:
    """The methods there are: "energy-ratio" (Caliskan 2018), "parametric" (van Dijk 2010) ..."""
    return list(_core.detectors())


def _samples(x: ArrayLike) -> NDArray[numpy.float32]:
    if isinstance(x, numpy.ma.MaskedArray):  # what is masked was not measured
        x = x.astype(float).filled(numpy.nan)
    array = numpy.asarray(x)
    if array.dtype.kind not in "iuf":
        raise ValueError(f"samples: are of type {array.dtype} (numbers are needed)")
    if array.ndim == 1:
        array = array[:, None]
    if array.ndim != 2 or array.shape[1] == 0:
        raise ValueError(f"samples: have shape {array.shape} (frames, or frames x channels)")
    if array.shape[1] > 32:
        raise ValueError(f"samples: have shape {array.shape} (frames come first; at most 32 channels)")
    with numpy.errstate(over="ignore"):  # beyond float32: not finite, and judged so
        return numpy.ascontiguousarray(array, dtype=numpy.float32)


def _number(name: str, value: object) -> float:
    try:
        return float(value)  # type: ignore[arg-type]
    except (TypeError, ValueError):
        raise ValueError(f"{name}: {value!r} is no number") from None


def _whole(name: str, value: object) -> int:
    try:
        number = operator.index(value)  # type: ignore[arg-type]
    except TypeError:
        raise ValueError(f"{name}: {value!r} is no whole number") from None
    if not -(10**6) < number < 10**6:
        raise ValueError(f"{name}: {number} is out of all range")
    return number


def _word(name: str, value: object) -> str:
    if not isinstance(value, str):
        raise ValueError(f"{name}: {value!r} is no word")
    return value


def _words(name: str, values: object) -> list[str]:
    if isinstance(values, str):
        return [values]
    try:
        return [_word(name, value) for value in values]  # type: ignore[attr-defined]
    except TypeError:
        raise ValueError(f"{name}: {values!r} is no list of words") from None


def _settings(parameters: Settings | None) -> dict[str, str]:
    if parameters is not None and not isinstance(parameters, Mapping):
        raise ValueError(f"parameters: {parameters!r} is no mapping of keys to values")

    def text(value: object) -> str:
        return str(value).lower() if isinstance(value, bool) else str(value)

    return {_word("parameters", key): text(value) for key, value in (parameters or {}).items()}


def analyze(
    x: ArrayLike,
    rate: float,
    teeth: int = 0,
    speed: float = 0.0,
    *,
    sensor: str = "acceleration",
    scale: float = 1.0,
    methods: Sequence[str] = ("energy-ratio",),
    parameters: Settings | None = None,
) -> dict[str, Any]:
    """Judges a recording: chatter or not, since when, at which frequency, and which speed would be stable.

    x: samples, shape (frames,) or (frames, channels), in the sensor's unit; float32 inside.
    rate: samples a second and channel [Hz], 100 to 1e6.
    teeth: of the tool, at most 200; 0 where nobody knows: then no speed is advised.
    speed: of the spindle, nominal [rpm]; 0 where nobody knows: it is looked for in the signal.
    sensor: "acceleration", "velocity", "displacement", "sound", "force", "current" or "speed".
    scale: SI units (m/s2, m/s, m, Pa, N, A) per unit of x.
    methods: detectors that run side by side, at most six; the answer is the first one's.
    parameters: as `stillcut-cli parameters` lists them, for example {"energy-ratio.chatter": 0.3}.

    Returns what the line `answer` of `stillcut-cli analyze --json` has (chapter "Scripts" of the manual) without what
    only a file has; each detector with its changes of state under "events". Read "remarks": what was assumed because it
    was not given. A channel that is no vibration (a constant, a row number, a tacho) is named in the answer and left
    out. What was not judged is "not-judged", never "no-chatter".
    """
    text = _core.analyze(
        _samples(x),
        _number("rate", rate),
        _word("sensor", sensor),
        _number("scale", scale),
        _whole("teeth", teeth),
        _number("speed", speed),
        _words("methods", methods),
        _settings(parameters),
    )
    answer: dict[str, Any] = json.loads(text)
    return answer


@dataclass(frozen=True)
class Verdict:
    """What a detector says after a block.

    time: end of the block, from the first sample on [s]; blocks have int(0.005 rate) samples, a little under 5 ms.
    state: "air", "stable", "onset", "chatter", or "not-judged" with its reason.
    frequency: of the chatter [Hz], 0: none. speed: of the spindle, as used [rpm], 0: not known.
    energy_ratio: energy of the chatter over all of the vibration's, 0 to 1. indicators: of the method, by their names.
    """

    time: float  # end of the block, from the first sample on [s]
    state: str  # "air", "stable", "onset", "chatter", or "not-judged"
    phase: str  # "air", "runup", "entry", "steady", "exit"
    reason: str  # one sentence; may be empty
    frequency: float  # of the chatter [Hz]; 0: none
    energy_ratio: float  # energy of the chatter over all of the vibration's, 0 to 1
    speed: float  # of the spindle, as used [rpm]; 0: not known
    kind: str  # "hopf", "flip", "forced", "unknown"
    early_warning: bool
    indicators: dict[str, float] = field(repr=False)  # of the method, by its own names

    @property
    def alarm(self) -> bool:
        """Chatter has begun or is there."""
        return self.state in ("onset", "chatter")


class Detector:
    """One method, fed block by block as samples come; it keeps what it has learned. One thread at a time.

    The arguments are those of analyze(); channels: how many side by side in each block.
    """

    def __init__(
        self,
        method: str = "energy-ratio",
        *,
        rate: float,
        teeth: int = 0,
        speed: float = 0.0,
        channels: int = 1,
        sensor: str = "acceleration",
        scale: float = 1.0,
        parameters: Settings | None = None,
    ) -> None:
        self._channels = _whole("channels", channels)
        self._fed = _core.Fed(
            _word("method", method),
            _number("rate", rate),
            self._channels,
            _word("sensor", sensor),
            _number("scale", scale),
            _whole("teeth", teeth),
            _number("speed", speed),
            _settings(parameters),
        )

    def feed(self, x: ArrayLike, speed: float = 0.0) -> list[Verdict]:
        """The next samples, shape (frames,) or (frames, channels), any number of frames.

        speed: of the spindle meanwhile, as measured [rpm]; 0: not measured.
        Returns a verdict for every block of 5 ms that became full; the rest waits for the next call.
        """
        samples = _samples(x)
        if samples.shape[1] != self._channels:
            raise ValueError(f"samples: have {samples.shape[1]} channels (this detector has {self._channels})")
        measured = _number("speed", speed)
        if not 0.0 <= measured <= 1e6:
            raise ValueError(f"speed: {measured} (0: not measured, to 1e6 rpm)")
        return [Verdict(**verdict) for verdict in self._fed.feed(samples, measured)]


@dataclass(frozen=True)
class Mode:
    """A mode of the tool or workpiece, at the tool tip.

    frequency: undamped natural frequency [Hz]; damping: ratio, above 0; stiffness: modal [N/m].
    direction: how it swings along the feed (x) and across (y); (1, 0) and (0, 1) are measured along one axis.
    """

    frequency: float  # undamped natural frequency [Hz]
    damping: float  # ratio, above 0
    stiffness: float  # modal [N/m]
    direction: tuple[float, float] = (1.0, 0.0)  # along the feed and across
    frequency_sd: float = 0.0  # standard deviations of a fit
    damping_sd: float = 0.0
    stiffness_sd: float = 0.0


@dataclass(frozen=True)
class Lobes:
    """Limits of stability over the spindle speed, each of shape (n,).

    speed [rpm]; depth: largest stable axial depth [m], inf: stable as deep as was searched, nan: not known;
    frequency: of the chatter beyond it [Hz], nan: there is none; details: all crossings.
    """

    speed: NDArray[numpy.float64]  # [rpm]
    depth: NDArray[numpy.float64]  # largest stable axial depth [m]; inf: stable as deep as searched; nan: not known
    frequency: NDArray[numpy.float64]  # of the chatter beyond it [Hz]; nan: there is none
    details: dict[str, Any] = field(repr=False)  # all crossings: the object of `stillcut-cli lobes --json`


def lobes(
    modes: Sequence[Mode],
    speeds: ArrayLike,
    *,
    teeth: int,
    diameter: float,
    tangential: float,
    radial: float,
    immersion: float = 1.0,
    down_milling: bool = True,
    helix: float = 0.0,
    deepest: float = 0.010,
    method: str = "exact",
) -> Lobes:
    """Stability limits of a cut.

    modes: at least one.
    speeds: of the spindle, shape (n,) [rpm].
    diameter: of the tool [m]; helix: [rad].
    tangential, radial: cutting force coefficients of a linear law [N/m^2].
    immersion: width of cut over the diameter, above 0 up to 1.
    deepest: how deep is searched [m].
    method: "exact", "sdm" (semi-discretization, Insperger 2004) or "zoa" (zeroth order, Altintas 1995).
    """
    if isinstance(modes, Mode):
        modes = [modes]
    rows = []
    for m in modes:
        if not isinstance(m, Mode) or len(m.direction) != 2:
            raise ValueError(f"modes: {m!r} is no Mode with two numbers of direction")
        rows.append([_number("modes", v) for v in (m.frequency, m.damping, m.stiffness, *m.direction)])
    cut = {
        "modes": rows,
        "teeth": _whole("teeth", teeth),
        "diameter": _number("diameter", diameter),
        "helix": _number("helix", helix),
        "tangential": _number("tangential", tangential),
        "radial": _number("radial", radial),
        "immersion": _number("immersion", immersion),
        "down": bool(down_milling),
    }
    if not 0.0 < cut["diameter"] <= 1.0:
        raise ValueError(f"diameter: {diameter} m (is it in mm?)")
    speed = numpy.atleast_1d(numpy.asarray(speeds, dtype=float))
    if speed.ndim != 1:
        raise ValueError(f"speeds: have shape {speed.shape} (one row of numbers)")
    details: dict[str, Any] = json.loads(_core.lobes(cut, speed, _number("deepest", deepest), _word("method", method)))
    depth = numpy.full(speed.shape, numpy.nan)
    frequency = numpy.full(speed.shape, numpy.nan)
    for k, row in enumerate(details["speeds"]):
        if row["crossings"]:
            depth[k] = 1e-3 * row["crossings"][0]["depth_mm"]
            if row["crossings"][0]["frequency_hz"]:
                frequency[k] = row["crossings"][0]["frequency_hz"]
        elif row["searched_to_mm"] >= 1e3 * deepest * (1.0 - 1e-9):
            depth[k] = numpy.inf
    return Lobes(speed, depth, frequency, details)


@dataclass(frozen=True)
class Fit:
    """Modes of a measured frequency response, and how well they hold it."""

    modes: list[Mode]  # rising in frequency
    misfit: float  # |fit - measured| over |measured| in the band
    band: tuple[float, float]  # that was fitted [Hz]
    remarks: list[str]
    frequency: NDArray[numpy.float64] = field(repr=False)  # lines of the band, shape (n,) [Hz]
    measured: NDArray[numpy.complex128] = field(repr=False)  # compliance there [m/N]
    fitted: NDArray[numpy.complex128] = field(repr=False)


def fit_modes(
    frequency: ArrayLike,
    response: ArrayLike,
    *,
    quantity: str = "compliance",
    coherence: ArrayLike = (),
    band: tuple[float, float] = (0.0, 0.0),
    modes: int = 0,
) -> Fit:
    """The modes of a structure from one frequency response, measured where it was hit.

    frequency: shape (n,), rising [Hz].
    response: complex, shape (n,): "compliance" [m/N], "mobility" [(m/s)/N] or "accelerance" [(m/s2)/N].
    coherence: shape (n,), 0 to 1; empty: not measured.
    band: to be fitted [Hz]; 0: a free end, found from the resonances.
    modes: how many; 0: as many as the measurement calls for.
    """
    f = numpy.asarray(frequency, dtype=float)
    h = numpy.asarray(response, dtype=complex)
    c = numpy.asarray(coherence, dtype=float)
    if f.ndim != 1 or h.shape != f.shape or c.size not in (0, f.size):
        raise ValueError(f"response: has shape {h.shape}, frequency {f.shape}, coherence {c.shape} (all the same)")
    if f.size and not (f[0] >= 0.0 and numpy.all(numpy.diff(f) > 0.0)):
        raise ValueError("frequency: must rise, from 0 Hz or above")
    if numpy.ndim(band) != 1 or len(band) != 2:
        raise ValueError(f"band: {band!r} is not two frequencies")
    if quantity not in ("compliance", "mobility", "accelerance"):
        raise ValueError(f"quantity '{quantity}' is none of compliance, mobility, accelerance")
    found = _core.fit_modes(f, h, quantity, c, _number("band", band[0]), _number("band", band[1]), _whole("modes", modes))
    found["modes"] = [Mode(**mode) for mode in found["modes"]]
    return Fit(**found)
