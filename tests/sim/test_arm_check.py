"""An arm that is not as its file says is refused in one sentence: which joint, and what would be valid."""

import re
from dataclasses import replace

import numpy as np
import pytest

from neurosym import check_world
from neurosym.errors import InvalidArm
from neurosym.sim.arm_check import check_arm
from neurosym.sim.config import Arm, TabletopConfig, loaded
from neurosym.sim.numeric_inverse import NumericInverse
from neurosym.sim.robot import UR10
from neurosym.sim.tabletop import Tabletop

BASE, HOME = (0.5, 0.0, 0.6), (0.0, 0.0, -0.2, 3.14159)
JOINTS, FINGERS, TOOL = (0, 1, 2, 3), (5, 6), 7
HALF_OPENING = 0.05
TABLE = TabletopConfig(
    table_x=(0.35, 0.65), table_y=(-0.25, 0.25), spawn_margin=0.1, size=(0.03, 0.09), height=(0.02, 0.06)
)
PALM = '<box size="0.06 0.12 0.02"/>'
ARM = (
    ("x", "prismatic", "base", "1 0 0"),
    ("y", "prismatic", "x", "0 1 0"),
    ("z", "prismatic", "y", "0 0 1"),
    ("turn", "revolute", "z", "1 0 0"),
)


def link(name, mass, shape="", at="0 0 0"):
    """Return a link of a URDF, perhaps with a shape."""
    if shape:
        shape = f'<collision><origin xyz="{at}"/><geometry>{shape}</geometry></collision>'
    inertia = '<inertia ixx="1e-4" iyy="1e-4" izz="1e-4" ixy="0" ixz="0" iyz="0"/>'
    return f'<link name="{name}"><inertial><mass value="{mass}"/>{inertia}</inertial>{shape}</link>'


def joint(name, kind, parent, axis="0 0 1", *, at="0 0 0", lower="-3.3", upper="3.3"):
    """Return the joint of a URDF that holds a link to its parent."""
    return (
        f'<joint name="j-{name}" type="{kind}"><parent link="{parent}"/><child link="{name}"/>'
        f'<origin xyz="{at}"/><axis xyz="{axis}"/>'
        f'<limit lower="{lower}" upper="{upper}" effort="100" velocity="2"/></joint>'
    )


def finger(name, kind="prismatic", parent="palm", middle="0.005", axis="0 1 0", lower="0", upper="0.05"):
    """Return a finger with a shape, and its joint."""
    box = link(name, 0.05, '<box size="0.02 0.01 0.1"/>', f"0 {middle} 0.06")
    return box + joint(name, kind, parent, axis, lower=lower, upper=upper)


def gantry(*, left=(), right=(), tool_at="0 0 0.105", tool_on="palm", palm_by="fixed", more=""):
    """Return the URDF of a gantry with two fingers, some things about it changed."""
    parts = [
        link("base", 0.3),
        *(link(name, 0.2) + joint(name, *held) for name, *held in ARM),
        *(link("palm", 0.3, PALM), joint("palm", palm_by, "turn")),
        finger("left", **dict(left)),
        finger("right", **{"axis": "0 -1 0", "middle": "-0.005"} | dict(right)),
        *(link("tool", 0.001), joint("tool", "fixed", tool_on, at=tool_at)),
        more,
    ]
    return f'<robot name="gantry">{"".join(parts)}</robot>'


def arm_of(urdf: str, **changes) -> Arm:
    inverse = NumericInverse(urdf, BASE, JOINTS, TOOL, HOME)
    arm = Arm(
        urdf=urdf,
        base=BASE,
        joints=JOINTS,
        fingers=FINGERS,
        tool=TOOL,
        inverse_kinematics=inverse,
        forces=(60.0, 60.0, 60.0, 10.0),
        half_opening=HALF_OPENING,
        finger_length=0.095,
        finger_half_width=0.01,
        finger_thickness=0.01,
        palm_half_size=(0.03, 0.06),
        mass_scale=0.05,
    )
    return replace(arm, **changes)


@pytest.fixture
def written(tmp_path):
    """Write a URDF and return its path."""
    path = tmp_path / "gantry.urdf"

    def write(text: str) -> str:
        path.write_text(text)
        return str(path)

    return write


def refusal(urdf: str, **changes) -> str:
    """Return what is said of an arm when a world is made with it, having checked that it is one sentence."""
    with pytest.raises(InvalidArm, match=r"^The arm (?!.*more than the arm reaches).*\.\Z") as error:
        Tabletop(TABLE, "gantry", arm=arm_of(urdf, **changes))
    return str(error.value)


@pytest.mark.usefixtures("engine")
def test_shipped_arm_and_a_hand_that_is_as_assumed_pass_and_it_lifts_a_box_whatever_mimics(written):
    check_arm(TabletopConfig(), UR10)
    joint, urdf = 'name="j-right" type="prismatic">', gantry()
    assert joint in urdf
    urdf = written(urdf.replace(joint, joint + '<mimic joint="j-left"/>'))
    world = Tabletop(TABLE, "gantry", arm=arm_of(urdf))
    world.try_out()
    check_world(world)


NEGATIVE = {"lower": "-0.05", "upper": "0"}
BOTH_WAYS = {"lower": "-0.05", "upper": "0.05"}
LOOSE = link("tip", 0.01) + joint("tip", "revolute", "left", lower="0", upper="1")


@pytest.mark.parametrize(
    ("changed", "said"),
    [
        ({"left": NEGATIVE}, r"j-left, whose limits are -0.05 and 0 m; valid: from 0 .* to half_opening"),
        ({"right": {"upper": "0.03"}}, r"j-right, whose limits are 0 and 0.03 m.* = 0.05 m"),
        ({"left": {"lower": "0.05", "upper": "0"}}, r"j-left, whose limits are 0.05 and 0 m"),
        ({"left": {"kind": "revolute"}}, r"j-left, whose joint does not slide"),
        ({"right": {"kind": "fixed"}}, r"j-right, whose joint is fixed; valid: two"),
        ({"right": {"axis": "0 1 0"}}, r"j-left and j-right, which both open to one side"),
        ({"right": {"axis": "-1 0 0"}}, r"j-right, which goes by \(-0.050, 0.000, 0.000\) m"),
        ({"right": {"axis": "0 -2 0"}}, r"j-right, which goes by \(0.000, -0.100, 0.000\) m"),
        (
            {"left": BOTH_WAYS | {"axis": "0 -1 0"}, "right": BOTH_WAYS | {"axis": "0 1 0"}},
            r"which are 0.000 m apart at 0 and 0.080 m at half_opening = 0.05 m; valid: they meet",
        ),
        ({"left": {"middle": "0.025"}}, r"which are 0.020 m apart at 0"),
        ({"left": {"middle": "0.025"}, "right": {"middle": "0.015"}}, r"tool j-tool, in whose frame"),
        ({"tool_at": "0 0 0"}, r"tool j-tool, in whose frame the fingers reach from .* m; valid:"),
        ({"tool_at": "0 0.03 0.105"}, r"tool j-tool, in whose frame"),
        ({"tool_on": "left"}, r"tool j-tool, which the finger j-left moves"),
        ({"palm_by": "revolute"}, r"j-palm, which moves the (finger|tool) .* none of joints"),
        ({"more": LOOSE}, r"j-tip on the finger j-left, which nothing drives"),
        ({"left": {"parent": "z"}}, r"j-turn among its joints, which does not move the finger j-left"),
    ],
    ids=lambda value: str(value) if isinstance(value, dict) else "",
)
def test_hand_that_is_not_as_assumed_is_refused(written, changed, said):
    urdf = written(gantry(**changed))
    with loaded(urdf) as (client, body):
        order = [client.getJointInfo(body, n)[1].decode() for n in range(client.getNumJoints(body))]
    known = {"tool": order.index("j-tool"), "fingers": (order.index("j-left"), order.index("j-right"))}
    said = re.sub(r"(j-[a-z]+)(?=[ ,\\])", lambda match: rf"{match[1]} \({order.index(match[1])}\)", said)
    told = refusal(urdf, **known)
    assert re.search(said, told), told


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({"fingers": (5, 12)}, r"no joint or link 12; valid: 0 to 7"),
        ({"tool": 8}, r"no joint or link 8"),
        ({"fingers": (6, 6)}, r"joint 6 twice"),
        ({"joints": (0, 1, 2)}, r"4 forces for 3 joints"),
        ({"joints": (0, 1, 2), "forces": (60.0, 60.0, 60.0)}, r"j-turn \(3\), which moves the finger"),
        ({"joints": (0, 1, 2, 4)}, r"j-palm \(4\), which neither turns nor slides"),
        ({"joints": (1, 0, 2, 3)}, r"joints = \(1, 0, 2, 3\); valid: in the order from base to tool"),
        ({"tool": 5}, r"tool j-left \(5\), which the finger j-left \(5\) moves"),
        ({"tool": 2}, r"j-turn \(3\) among its joints, which does not move the tool j-z \(2\)"),
        ({"tool": 4}, r"tool j-palm \(4\), in whose frame the fingers reach"),
        ({"half_opening": 50.0}, r"limits are 0 and 0.05 m; valid: .* = 50 m"),
        ({"half_opening": 0.0}, r"half_opening = 0.0; valid: greater than 0"),
        ({"base": (0.5, 0.0, 0.7)}, r"inverse_kinematics that brings the tool to \(0.350, -0.250, 0.120\) m"),
        ({"inverse_kinematics": lambda points: np.zeros((len(points), 2))}, r"gives \(8, 2\) for 8 points"),
        ({"inverse_kinematics": lambda _: np.full((8, 4), np.nan)}, r"valid: finite angles"),
    ],
)
def test_description_that_does_not_fit_the_file_is_refused(written, changes, said):
    told = refusal(written(gantry()), **changes)
    assert re.search(said, told), told


NO_TREE = "its joints make no tree of its links"


@pytest.mark.parametrize(
    ("change", "said"),
    [
        (("j-x", "j-x"), None),
        (("</robot>", ""), "it is no whole XML"),
        (('type="revolute"', 'type="wheel"'), "PyBullet says: Joint j-turn has unknown type: wheel"),
        (('<child link="palm"/>', '<child link="hand"/>'), NO_TREE),
        (("</robot>", '<link name="alone"/></robot>'), NO_TREE),
        ((PALM, '<mesh filename="package://hand/palm.stl"/>'), "PyBullet says: .* find 'hand/palm.stl'"),
        ((PALM, '<mesh filename="palm.stl"/>'), "PyBullet says: .* cannot find 'palm.stl' in any directory"),
        ((PALM, '<mesh filename="empty.stl"/>'), "PyBullet says: .* cannot extract mesh from '.*empty.stl'"),
    ],
)
def test_file_that_cannot_be_read_is_told_as_that_and_prints_nothing(written, tmp_path, capfd, change, said):
    (tmp_path / "empty.stl").touch()
    urdf = written(gantry().replace(*change))
    if said is None:
        Tabletop(TABLE, "gantry", arm=arm_of(urdf))
    else:
        assert re.search(f"cannot be read from {re.escape(urdf)}: {said}", refusal(urdf))
    assert capfd.readouterr() == ("", "")


def test_file_that_is_none_and_a_hand_without_shapes_are_told_as_that(tmp_path, written):
    assert "gone.urdf: there is no such file" in refusal(str(tmp_path / "gone.urdf"))
    assert "it is a folder" in refusal(str(tmp_path))
    urdf = re.sub(r'<collision><origin xyz="0 0.005.*?</collision>', "", gantry())
    assert "j-left (5), which has no collision shape" in refusal(written(urdf))


def test_mended_file_is_read_anew(written):
    refusal(written(gantry(left=NEGATIVE)))
    world = Tabletop(TABLE, "gantry", arm=arm_of(written(gantry())))
    assert len(world.sample_scene(np.random.default_rng(0), 1)) == 1


@pytest.mark.parametrize("changed", [('value="0.05"', 'value="0"'), ("1e-4", "0")])
def test_hand_that_seems_right_and_does_not_lift_is_told_by_check_world(written, changed):
    world = Tabletop(TABLE, "gantry", arm=arm_of(written(gantry().replace(*changed))))
    with pytest.raises(InvalidArm, match=r"does not lift a plain box of 0\.05 x 0\.05 x 0\.05 m: .* 0\.2 m"):
        check_world(world)


@pytest.mark.parametrize("changed", [{"size": (0.1, 0.12)}, {"friction": 0.001}])
def test_box_that_no_hand_could_hold_or_that_the_world_makes_slip_is_no_fault_of_the_hand(written, changed):
    assert Tabletop(replace(TABLE, **changed), "gantry", arm=arm_of(written(gantry()))).try_out() is None
