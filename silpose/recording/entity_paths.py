"""Every entity path of a recording, under the word of the room it comes from."""

TRUE_SKELETON = "/motion/skeleton"
TRUE_HEADING = "/motion/heading"
TRUE_POSE = "/motion/pose"

CAMERA = "/silhouette/camera"
MASK = "/silhouette/camera/mask"
EDGE_POINTS = "/silhouette/camera/edge_points"

SEQUENCE = "/dataset/sequence"

HISTOGRAM = "/descriptor/histogram"
CODEBOOK = "/descriptor/codebook"
VOTES = "/descriptor/codebook/votes"
SPACE = "/descriptor/space"  # the plane of two principal components of shape contexts
SPACE_CONTEXTS = "/descriptor/space/contexts"
SPACE_CENTRES = "/descriptor/space/centres"
SPACE_POINTS = "/descriptor/space/points"

ESTIMATED_SKELETON = "/regression/skeleton"
ESTIMATED_POSE = "/regression/pose"
ESTIMATED_HEADING = "/regression/heading"
HEADING_NORM = "/regression/heading_norm"
ACTIVATIONS = "/regression/activations"

REASONS = "/regression/reasons"  # the training examples behind an estimate
REASONS_OUTLINES = "/regression/reasons/outlines"
REASONS_SKELETONS = "/regression/reasons/skeletons"
REASONS_WEIGHTS = "/regression/reasons/weights"

COLUMN_NORMS = "/regression/bridges/norms"
COLUMNS_LEFT = "/regression/bridges/columns_left"
OBJECTIVE = "/regression/bridges/objective"
FEATURES = "/silhouette/camera/retained"  # one entity below it per body part

MODES = "/regression/modes"  # below it a skeleton, a heading, a pose and a weight per mode

TRACKS = "/tracking/tracks"  # below it a skeleton, a heading, a pose per method
TRACK_NAMES = "/tracking/names"
HYPOTHESES = "/tracking/hypotheses"  # below it likewise, per mode of a tracker's hypotheses
BELIEF = "/tracking/belief"
STATE = "/tracking/state"
KERNELS = "/tracking/kernels"  # one entity below it per tracker

ERROR = "/evaluation/error"  # one entity below it per method

FIGURE = "/run/figure"
SETTINGS = "/run/settings"
METRICS = "/run/metrics"


def of(root: str, name: str) -> str:
    """Give the entity below another that belongs to a method, or whatever is compared."""
    return f"{root}/{name.replace(' ', '_')}"  # blanks in paths want escapes
