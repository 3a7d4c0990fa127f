"""Skeletons with the names that many programs give their joints, written as indented text."""

import numpy as np

from silpose.core.skeleton import POINTS
from silpose.motion.capture.raw_motion import RawMotion

_MIDDLE = {
    "root": (0, 95, 0), "spine1": (0, 103, -1), "spine2": (0, 112, -1), "spine3": (0, 118, 0),
    "chest": (0, 125, 0), "neck": (0, 145, -2), "neck2": (0, 150, -1), "head": (0, 158, 0),
    "head_top": (0, 176, 0), "ground": (0, 0, 0), "jaw": (0, 158, 6), "tail": (0, 92, -10),
}  # fmt: skip
_LEFT = {
    "collar": (3, 140, 0), "shoulder": (17, 141, -1), "upper_arm_middle": (29, 141, -2),
    "elbow": (43, 141, -4), "forearm_middle": (55, 141, -3), "wrist": (67, 141, -2),
    "hand": (76, 141, -1), "finger": (80, 141, -1), "finger2": (83, 141, -1),
    "index": (76, 141, 2), "thumb": (70, 139, 3), "thumb2": (73, 138, 5),
    "pelvis": (6, 98, 0), "hip": (9, 92, 0), "thigh_middle": (9, 72, 0), "knee": (9, 50, 1),
    "shin_middle": (9, 30, 0), "ankle": (9, 9, -2), "heel": (9, 2, -8), "toes": (10, 3, 12),
    "toes_end": (10, 2, 18), "eye": (3, 162, 8), "breast": (7, 128, 10),
}  # fmt: skip
_PLACES = {name: np.array(place, float) for name, place in _MIDDLE.items()}
for _name, _place in _LEFT.items():
    _PLACES[f"left_{_name}"] = np.array(_place, float)
    _PLACES[f"right_{_name}"] = np.array(_place, float) * (-1, 1, 1)


class Skeleton:
    """Names, tree and places of joints, and which of them are the skeleton's.

    `text` has a line per joint, ``NAME = PLACE``, indented by its depth; a ``~`` before the place
    says that this joint is not to be matched. A line with ``@`` and those below it stand for the
    left and the right side, `sides` take the place of the ``@``.
    """

    def __init__(self, text, sides=("Left", "Right")):
        self.names, self.parents, self.places, self.expected = [], [], [], {}
        lines = [line for line in text.splitlines() if line.strip()]
        self._add(lines, 0, -1, sides, None)

    def _add(self, lines, k, parent, sides, side):
        depth = _depth(lines[k])
        for i in range(k, len(lines)):
            if _depth(lines[i]) < depth:
                return
            if _depth(lines[i]) > depth:
                continue
            both = side is None and "@" in lines[i]
            for own in ("left", "right") if both else (side,):
                self._node(lines, i, parent, sides, own)

    def _node(self, lines, i, parent, sides, side):
        name, place = (part.strip() for part in lines[i].split("="))
        if side is not None:
            name = name.replace("@", sides[side == "right"])
        wanted = not place.startswith("~")
        place = place.removeprefix("~")
        place = place if side is None or place in _MIDDLE else f"{side}_{place}"
        j = len(self.names)
        self.names.append(name)
        self.parents.append(parent)
        self.places.append(_PLACES[place])
        if wanted and place in POINTS:
            self.expected[place] = name
        if i + 1 < len(lines) and _depth(lines[i + 1]) > _depth(lines[i]):
            self._add(lines, i + 1, j, sides, side)

    def raw(self, names=None, turn=None, scale=1.0):
        """Motion of three frames, in which the person stands."""
        places = scale * np.array(self.places) @ (np.eye(3) if turn is None else turn).T
        offsets = np.array([p - (places[q] if q >= 0 else 0) for p, q in
                            zip(places, self.parents, strict=True)])  # fmt: skip
        return RawMotion(
            file="take.bvh",
            names=tuple(names or self.names),
            parents=tuple(self.parents),
            offsets=offsets,
            rotations=np.tile(np.eye(3), (3, len(places), 1, 1)),
            positions=np.tile(places, (3, 1, 1)),
            frames_per_second=30.0,
        )


def _depth(line):
    return len(line) - len(line.lstrip())


_L, _l = ("L", "R"), ("l", "r")

_PLAIN = """
Hips = root
 @UpLeg = hip
  @Leg = knee
   @Foot = ankle
    @ToeBase = toes
     @Toe_End = ~toes_end
 Spine = ~spine1
  Spine1 = ~spine2
   Spine2 = chest
    @Shoulder = collar
     @Arm = shoulder
      @ForeArm = elbow
       @Hand = wrist
        @HandThumb1 = ~thumb
         @HandThumb2 = ~thumb2
        @HandIndex1 = ~index
        @HandMiddle1 = hand
         @HandMiddle2 = ~finger
          @HandMiddle3 = ~finger2
    Neck = neck
     Head = head
      @Eye = ~eye
      HeadTop_End = ~head_top
"""

_SHORT = """
root = root
 @h = hip
  @k = knee
   @a = ankle
    @t = toes
     @t/end = ~toes_end
 s = ~spine1
  s1 = chest
   n = neck
    h = head
     h/end = head_top
   @c = collar
    @s = shoulder
     @e = elbow
      @w = wrist
       @w/end = hand
"""

SKELETONS = {
    "Mixamo": Skeleton(
        "\n".join(
            f"{' ' * _depth(line)}mixamorig:{line.strip()}" for line in _PLAIN.splitlines() if line
        )
    ),
    "prefix on all but one": Skeleton(
        "\n".join(
            f"{' ' * _depth(line)}{'' if 'Spine1' in line else 'Actor_01_'}{line.strip()}"
            for line in _PLAIN.splitlines()
            if line
        )
    ),
    "LAFAN1": Skeleton(_PLAIN),
    "lower case": Skeleton(
        "\n".join(line.lower() for line in _PLAIN.splitlines()), ("left", "right")
    ),
    "upper case with spaces": Skeleton(
        """
PELVIS = root
 @ THIGH = hip
  @ SHIN = knee
   @ FOOT = ankle
    @ TOE = toes
 LOWER BACK = ~spine1
  UPPER BACK = chest
   NECK = neck
    HEAD = head
   @ COLLAR = collar
    @ UPPER ARM = shoulder
     @ FORE ARM = elbow
      @ HAND = wrist
       @ FINGERS = hand
""",
        ("LEFT", "RIGHT"),
    ),
    "3ds Max Biped": Skeleton(
        """
Bip01 = ~root
 Bip01 Footsteps = ~ground
 Bip01 Pelvis = root
  Bip01 Spine = ~spine1
   Bip01 @ Thigh = hip
    Bip01 @ Calf = knee
     Bip01 @ Foot = ankle
      Bip01 @ Toe0 = toes
       Bip01 @ Toe0Nub = ~toes_end
   Bip01 Spine1 = ~spine2
    Bip01 Spine2 = chest
     Bip01 Neck = neck
      Bip01 Head = head
       Bip01 HeadNub = ~head_top
      Bip01 @ Clavicle = collar
       Bip01 @ UpperArm = shoulder
        Bip01 @ Forearm = elbow
         Bip01 @ ForeTwist = ~forearm_middle
         Bip01 @ Hand = wrist
          Bip01 @ Finger0 = ~thumb
          Bip01 @ Finger1 = hand
""",
        _L,
    ),
    "Unreal 5": Skeleton(
        """
root = ~ground
 pelvis = root
  thigh_@ = hip
   thigh_twist_01_@ = ~thigh_middle
   calf_@ = knee
    calf_twist_01_@ = ~shin_middle
    foot_@ = ankle
     ball_@ = toes
  spine_01 = ~spine1
   spine_02 = ~spine2
    spine_03 = ~spine3
     spine_04 = ~spine3
      spine_05 = chest
       clavicle_@ = collar
        upperarm_@ = shoulder
         upperarm_twist_01_@ = ~upper_arm_middle
         lowerarm_@ = elbow
          lowerarm_twist_01_@ = ~forearm_middle
          hand_@ = wrist
           thumb_01_@ = ~thumb
           index_metacarpal_@ = ~index
            index_01_@ = ~index
           middle_metacarpal_@ = ~index
            middle_01_@ = hand
             middle_02_@ = ~finger
       neck_01 = neck
        neck_02 = ~neck2
         head = head
 ik_foot_root = ~ground
  ik_foot_@ = ~ankle
 ik_hand_root = ~ground
  ik_hand_@ = ~wrist
""",
        _l,
    ),
    "Rigify": Skeleton(
        """
root = ~ground
 DEF-spine = root
  DEF-pelvis.@ = ~pelvis
  DEF-thigh.@ = hip
   DEF-thigh.@.001 = ~thigh_middle
    DEF-shin.@ = knee
     DEF-shin.@.001 = ~shin_middle
      DEF-foot.@ = ankle
       DEF-toe.@ = toes
  DEF-spine.001 = ~spine1
   DEF-spine.002 = ~spine2
    DEF-spine.003 = chest
     DEF-spine.004 = neck
      DEF-spine.005 = ~neck2
       DEF-spine.006 = head
     DEF-shoulder.@ = collar
      DEF-upper_arm.@ = shoulder
       DEF-upper_arm.@.001 = ~upper_arm_middle
        DEF-forearm.@ = elbow
         DEF-forearm.@.001 = ~forearm_middle
          DEF-hand.@ = wrist
           DEF-f_index.01.@ = ~index
           DEF-f_middle.01.@ = hand
           DEF-thumb.01.@ = ~thumb
     DEF-breast.@ = ~breast
""",
        _L,
    ),
    "CMU ASF": Skeleton(
        """
root = root
 @hipjoint = ~pelvis
  @femur = hip
   @tibia = knee
    @foot = ankle
     @toes = toes
 lowerback = ~spine1
  upperback = ~spine2
   thorax = chest
    lowerneck = ~neck
     upperneck = neck
      head = head
    @clavicle = collar
     @humerus = shoulder
      @radius = elbow
       @wrist = ~forearm_middle
        @hand = wrist
         @fingers = hand
        @thumb = ~thumb
""",
        _l,
    ),
    "Kinect 2": Skeleton("""
SpineBase = root
 SpineMid = ~spine2
  SpineShoulder = chest
   Neck = neck
    Head = head
   Shoulder@ = shoulder
    Elbow@ = elbow
     Wrist@ = wrist
      Hand@ = hand
       HandTip@ = ~finger
      Thumb@ = ~thumb
 Hip@ = hip
  Knee@ = knee
   Ankle@ = ankle
    Foot@ = toes
"""),
    "Azure Kinect": Skeleton(
        """
PELVIS = root
 SPINE_NAVAL = ~spine2
  SPINE_CHEST = chest
   NECK = neck
    HEAD = head
   CLAVICLE_@ = collar
    SHOULDER_@ = shoulder
     ELBOW_@ = elbow
      WRIST_@ = wrist
       HAND_@ = hand
        HANDTIP_@ = ~finger
       THUMB_@ = ~thumb
 HIP_@ = hip
  KNEE_@ = knee
   ANKLE_@ = ankle
    FOOT_@ = toes
""",
        ("LEFT", "RIGHT"),
    ),
    "OptiTrack": Skeleton(
        """
Skeleton 001_Hip = root
 Skeleton 001_Ab = ~spine1
  Skeleton 001_Chest = chest
   Skeleton 001_Neck = neck
    Skeleton 001_Head = head
   Skeleton 001_@Shoulder = collar
    Skeleton 001_@UArm = shoulder
     Skeleton 001_@FArm = elbow
      Skeleton 001_@Hand = wrist
 Skeleton 001_@Thigh = hip
  Skeleton 001_@Shin = knee
   Skeleton 001_@Foot = ankle
    Skeleton 001_@Toe = toes
""",
        _L,
    ),
    "Bandai-Namco": Skeleton(
        """
joint_Root = ~ground
 Hips = root
  Spine = ~spine1
   Chest = chest
    Neck = neck
     Head = head
    Shoulder_@ = collar
     UpperArm_@ = shoulder
      LowerArm_@ = elbow
       Hand_@ = wrist
  UpperLeg_@ = hip
   LowerLeg_@ = knee
    Foot_@ = ankle
     Toes_@ = toes
""",
        _L,
    ),
    "Xsens": Skeleton("""
Hips = root
 Chest = ~spine1
  Chest2 = ~spine2
   Chest3 = ~spine3
    Chest4 = chest
     Neck = neck
      Head = head
     @Collar = collar
      @Shoulder = shoulder
       @Elbow = elbow
        @Wrist = wrist
 @Hip = hip
  @Knee = knee
   @Ankle = ankle
    @Toe = toes
"""),
    "Rokoko": Skeleton("""
Hips = root
 Spine1 = ~spine1
  Spine2 = ~spine2
   Spine3 = ~spine3
    Spine4 = chest
     Neck = neck
      Head = head
     @Shoulder = collar
      @Arm = shoulder
       @ForeArm = elbow
        @Hand = wrist
 @Thigh = hip
  @Shin = knee
   @Foot = ankle
    @Toe = toes
"""),
    "SMPL": Skeleton(
        """
m_avg_root = ~root
 m_avg_Pelvis = root
  m_avg_@_Hip = hip
   m_avg_@_Knee = knee
    m_avg_@_Ankle = ankle
     m_avg_@_Foot = toes
  m_avg_Spine1 = ~spine1
   m_avg_Spine2 = ~spine2
    m_avg_Spine3 = chest
     m_avg_Neck = neck
      m_avg_Head = head
     m_avg_@_Collar = collar
      m_avg_@_Shoulder = shoulder
       m_avg_@_Elbow = elbow
        m_avg_@_Wrist = wrist
         m_avg_@_Hand = hand
""",
        _L,
    ),
    "DAZ": Skeleton(
        """
hip = ~root
 pelvis = root
  @ThighBend = hip
   @ThighTwist = ~thigh_middle
    @Shin = knee
     @Foot = ankle
      @Metatarsals = ~heel
       @Toe = toes
 abdomenLower = ~spine1
  abdomenUpper = ~spine2
   chestLower = ~spine3
    chestUpper = chest
     @Collar = collar
      @ShldrBend = shoulder
       @ShldrTwist = ~upper_arm_middle
        @ForearmBend = elbow
         @ForearmTwist = ~forearm_middle
          @Hand = wrist
           @Mid1 = hand
     neckLower = neck
      neckUpper = ~neck2
       head = head
""",
        _l,
    ),
    "Character Creator": Skeleton(
        """
RL_BoneRoot = ~ground
 CC_Base_Hip = ~root
  CC_Base_Pelvis = root
   CC_Base_@_Thigh = hip
    CC_Base_@_ThighTwist01 = ~thigh_middle
    CC_Base_@_Calf = knee
     CC_Base_@_Foot = ankle
      CC_Base_@_ToeBase = toes
  CC_Base_Waist = ~spine1
   CC_Base_Spine01 = ~spine2
    CC_Base_Spine02 = chest
     CC_Base_NeckTwist01 = neck
      CC_Base_NeckTwist02 = ~neck2
       CC_Base_Head = head
        CC_Base_JawRoot = ~jaw
     CC_Base_@_Clavicle = collar
      CC_Base_@_Upperarm = shoulder
       CC_Base_@_UpperarmTwist01 = ~upper_arm_middle
       CC_Base_@_Forearm = elbow
        CC_Base_@_Hand = wrist
         CC_Base_@_Mid1 = hand
""",
        _L,
    ),
    "VRM": Skeleton(
        """
Root = ~ground
 J_Bip_C_Hips = root
  J_Bip_C_Spine = ~spine1
   J_Bip_C_Chest = ~spine2
    J_Bip_C_UpperChest = chest
     J_Sec_@_Bust1 = ~breast
     J_Bip_C_Neck = neck
      J_Bip_C_Head = head
       J_Adj_@_FaceEye = ~eye
     J_Bip_@_Shoulder = collar
      J_Bip_@_UpperArm = shoulder
       J_Bip_@_LowerArm = elbow
        J_Bip_@_Hand = wrist
         J_Bip_@_Middle1 = hand
  J_Bip_@_UpperLeg = hip
   J_Bip_@_LowerLeg = knee
    J_Bip_@_Foot = ankle
     J_Bip_@_ToeBase = toes
""",
        _L,
    ),
    "MakeHuman": Skeleton(
        """
root = root
 pelvis.@ = ~pelvis
  upperleg01.@ = hip
   upperleg02.@ = ~thigh_middle
    lowerleg01.@ = knee
     lowerleg02.@ = ~shin_middle
      foot.@ = ankle
       toe1-1.@ = toes
 spine05 = ~spine1
  spine04 = ~spine2
   spine03 = ~spine3
    spine02 = chest
     clavicle.@ = collar
      shoulder01.@ = ~shoulder
       upperarm01.@ = shoulder
        upperarm02.@ = ~upper_arm_middle
         lowerarm01.@ = elbow
          lowerarm02.@ = ~forearm_middle
           wrist.@ = wrist
     neck01 = neck
      neck02 = ~neck2
       head = head
""",
        _L,
    ),
    "DeepMotion": Skeleton(
        """
root = ~ground
 hips_JNT = root
  @_upleg_JNT = hip
   @_leg_JNT = knee
    @_foot_JNT = ankle
     @_toebase_JNT = toes
  spine_JNT = ~spine1
   spine1_JNT = ~spine2
    spine2_JNT = chest
     neck_JNT = neck
      head_JNT = head
     @_shoulder_JNT = collar
      @_arm_JNT = shoulder
       @_forearm_JNT = elbow
        @_hand_JNT = wrist
""",
        _l,
    ),
    "Poser": Skeleton(
        """
hip = root
 abdomen = ~spine1
  chest = chest
   neck = neck
    head = head
   @Collar = collar
    @Shldr = shoulder
     @ForeArm = elbow
      @Hand = wrist
 @Buttock = ~pelvis
  @Thigh = hip
   @Shin = knee
    @Foot = ankle
     @Toe = toes
""",
        _l,
    ),
    "short": Skeleton(_SHORT),
}


def renamed(middle, side, sides):
    """Names of joints of the LAFAN1 skeleton in other words.

    Parameters
    ----------
    middle : str
        Hips, three spine joints, neck, head.
    side : str
        Upper leg, lower leg, foot, toes, collar, upper arm, forearm, hand; ``@`` is the side.
    sides : tuple of str
        Left and right.
    """
    ours = ("UpLeg", "Leg", "Foot", "ToeBase", "Shoulder", "Arm", "ForeArm", "Hand")
    words = dict(zip(("Hips", "Spine", "Spine1", "Spine2", "Neck", "Head"), middle.split(),
                     strict=True))  # fmt: skip
    for own, side_word in zip(("Left", "Right"), sides, strict=True):
        theirs = [name.replace("@", side_word) for name in side.split()]
        words |= {f"{own}{name}": word for name, word in zip(ours, theirs, strict=True)}
    return [words.get(name, f"other{j}") for j, name in enumerate(SKELETONS["LAFAN1"].names)]
