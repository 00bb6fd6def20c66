"""Maps of surfaces, from objects and arrays."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import ertel


class Topography:
    """The used attributes of a topography of SurfaceTopography."""

    unit = "um"
    physical_sizes = (60.0, 40.0)

    def __init__(self, heights: np.ndarray) -> None:
        self._heights = heights

    def heights(self) -> np.ndarray:
        return self._heights


def _case(folder: Path, file: str) -> ertel.Case:
    return ertel.Case(
        folder=folder,
        contact={"kind": "circular", "radius": "12.5 mm", "load": "15 N"},
        bodies={"body_1": "steel", "body_2": "steel"},
        motion={"body_1_speed": "0.18 m/s", "body_2_speed": "0 m/s"},
        lubricant="squalane-pip",
        temperature="40 degC",
        surface=[{"kind": "map", "body": "body_2", "x": "0 m", "file": file, "level": "none"}],
    )


def test_objects_and_arrays_are_written_for_a_case(tmp_path: Path) -> None:
    x, y = np.meshgrid(np.arange(30), np.arange(20), indexing="ij")
    heights = 0.05 * np.sin(0.4 * x) + 0.002 * y
    masked = np.ma.masked_array(heights, mask=(x == 3) & (y == 7))
    ertel.write_map(tmp_path / "object.sdf", Topography(masked))
    ertel.write_map(tmp_path / "array.sdf", heights * 1e-6, sizes=(60e-6, 40e-6), unit="m")
    found = [_case(tmp_path, f"{name}.sdf").si["surfaces"][0] for name in ("object", "array")]
    assert [surface["missing"] for surface in found] == [1, 0]
    for surface in found:
        assert surface["points"] == [30, 20]
        assert surface["spacing"] == pytest.approx([2e-6, 2e-6])
        assert surface["levelled"]["sz"] == pytest.approx(1e-6 * np.ptp(heights))
    assert found[1]["levelled"]["sq"] == pytest.approx(1e-6 * np.std(heights))
    assert found[0]["hash"] != found[1]["hash"]
    profile = ertel.write_map(tmp_path / "profile.sdf", [1.0, 2.0, 0.0, 1.5, 3.0, 1.0], sizes=60, unit="nm")
    assert _case(tmp_path, profile.name).si["surfaces"][0]["points"] == [6, 1]


@pytest.mark.parametrize(
    ("surface", "more", "says"),
    [
        ([[1.0, 2.0]], {"sizes": (1, 1)}, "unit"),
        ([[1.0, 2.0]], {"unit": "um"}, "sizes"),
        ([[1.0, 2.0]], {"unit": "furlong", "sizes": (1, 1)}, "furlong"),
        ([[1.0, 2.0]], {"unit": "um", "sizes": 1}, "a size for each"),
        (np.zeros((4, 4)), {"unit": "um", "sizes": (1, 0)}, "above zero"),
        (np.full((4, 4), np.inf), {"unit": "um", "sizes": (1, 1)}, "infinite"),
        ([[1.0]], {"unit": "um", "sizes": (1, 1)}, "1 x 1 points: a map has 4 in each direction at least"),
        ([1.0, 2.0, 3.0], {"unit": "um", "sizes": 1}, "a profile 4 to 4194304"),
        (np.zeros((3000, 3000)), {"unit": "um", "sizes": (1, 1)}, "3000 x 3000 points: .* 4194304 at most"),
        (np.full((4, 4), 1j), {"unit": "um", "sizes": (1, 1)}, "complex"),
        ([["a"]], {"unit": "um", "sizes": (1, 1)}, "numbers"),
    ],
)
def test_invalid_maps_are_refused(tmp_path: Path, surface: object, more: dict[str, object], says: str) -> None:
    with pytest.raises(ertel.CaseError, match=says):
        ertel.write_map(tmp_path / "a.sdf", surface, **more)  # type: ignore[arg-type]
    with pytest.raises(ertel.CaseError, match="cannot be read"):
        _case(tmp_path, "a.sdf")
