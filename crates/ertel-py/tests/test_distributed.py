"""Studies on a Dask cluster: the table of `ertel.sweep`, digit for digit, whatever happens to the workers."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

import ertel

distributed = pytest.importorskip("distributed")
ertel_distributed = pytest.importorskip("ertel.distributed")


@pytest.fixture
def study(tmp_path: Path, cases: Path) -> Path:
    (tmp_path / "roller.toml").write_text((cases / "roller.toml").read_text())
    path = tmp_path / "films.toml"
    path.write_text(
        'case = "roller.toml"\n'
        '[[axis]]\nkey = "motion.entrainment_speed"\nfrom = "0.3 m/s"\nto = "4 m/s"\npoints = 20\nspacing = "log"\n'
        '[[axis]]\nkey = "contact.load"\nvalues = ["50 kN/m", "90 kN/m", "160 kN/m"]\n'
        '[[axis]]\nkey = "mesh.target_error"\nvalues = ["1 %"]\n'
    )
    return path


def spread(study: Path, folder: Path) -> Any:
    """The table of a study on two workers, which is that of one process to the byte."""
    ertel.sweep(study, folder / "alone")
    with (
        distributed.LocalCluster(n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None) as cluster,
        distributed.Client(cluster) as client,
    ):
        rows = ertel_distributed.sweep(study, client, folder / "spread", points_per_task=1)
    assert rows["converged"].all()
    assert (folder / "spread" / "results.csv").read_bytes() == (folder / "alone" / "results.csv").read_bytes()
    return rows


def test_killed_workers_lose_nothing(study: Path, tmp_path: Path) -> None:
    """Two of four workers are killed in mid-study; then the client stops, and another run goes on."""
    alone = tmp_path / "alone"
    ertel.sweep(study, alone, jobs=2)
    spread = tmp_path / "spread"
    events = []

    class Stop(Exception):
        pass

    with (
        distributed.LocalCluster(n_workers=4, threads_per_worker=1, processes=True, dashboard_address=None) as cluster,
        distributed.Client(cluster) as client,
    ):

        def watch(event: dict[str, int]) -> None:
            events.append(event["n_finished"])
            if len(events) == 3:
                for worker in list(cluster.workers.values())[:2]:
                    worker.process.process.kill()
            if len(events) == 8:
                raise Stop

        with pytest.raises(Stop):
            ertel_distributed.sweep(study, client, spread, points_per_task=4, progress=watch)
        kept = len((spread / "journal.jsonl").read_text().splitlines())
        assert 20 <= kept < 60
        rows = ertel_distributed.sweep(study, client, spread, points_per_task=7)
    assert len(rows) == 60 and rows["converged"].all()
    assert (spread / "results.csv").read_bytes() == (alone / "results.csv").read_bytes()
    journal = (spread / "journal.jsonl").read_text().splitlines()
    assert len(journal) == 60, "a point was solved and kept twice"
    assert rows.attrs["summary"]["n_new"] == 0, "the client solved what the workers should"


def test_machines_are_points(tmp_path: Path, cases: Path) -> None:
    """Gears, all contacts along their path at each point."""
    (tmp_path / "gears.toml").write_text((cases / "machine" / "fzg-c.toml").read_text())
    study = tmp_path / "torques.toml"
    study.write_text(
        'case = "gears.toml"\n'
        '[[axis]]\nkey = "machine.pinion_torque"\nvalues = ["50 N.m", "100 N.m", "200 N.m"]\n'
        '[[axis]]\nkey = "machine.points"\nvalues = [3]\n'
    )
    assert (spread(study, tmp_path)["mesh_loss"] > 0.0).all()


def test_runs_in_time_are_points(tmp_path: Path, cases: Path) -> None:
    """Points that start from no other, in any order on any worker."""
    text = (cases / "roller.toml").read_text() + '\n[transient]\nduration = "0.3 ms"\nload = { course = "ramp", end = "0.2 ms", to = "50 kN/m" }\n'
    (tmp_path / "roller.toml").write_text(text)
    study = tmp_path / "loads.toml"
    study.write_text('case = "roller.toml"\n[[axis]]\nkey = "transient.load.to"\nvalues = ["40 kN/m", "60 kN/m", "80 kN/m"]\n')
    assert (spread(study, tmp_path)["film_minimum_lowest_m"] > 0.0).all()


def test_bad_studies_are_refused_before_anything_is_sent(tmp_path: Path) -> None:
    path = tmp_path / "bad.toml"
    path.write_text('case = "nowhere.toml"\n[[axis]]\nkey = "contact.load"\nvalues = ["1 N"]\n')
    with pytest.raises(ertel.CaseError, match="nowhere.toml"):
        ertel_distributed.sweep(path, client=None, folder=tmp_path / "out")
