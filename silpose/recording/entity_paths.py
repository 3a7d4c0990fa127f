"""Every entity path of a recording; it begins with the package that its data come from."""

TRUE_SKELETON = "/motion/skeleton"
TRUE_HEADING = "/motion/heading"
TRUE_POSE = "/motion/pose"

CAMERA = "/silhouette/camera"
PICTURE = "/silhouette/camera/picture"
MASK = "/silhouette/camera/mask"
MASK_STATE = "/silhouette/state"
FRAME = "/silhouette/camera/frame"  # where the image ends
SEEN = "/silhouette/seen"  # whether anyone is in a mask
EDGE_POINTS = "/silhouette/camera/edge_points"
OVERLAID_SKELETON = "/silhouette/camera/skeleton"  # the estimated pose on the mask
OVERLAID_OUTLINE = "/silhouette/camera/outline"  # of the fitted body
CAPTION = "/silhouette/camera/caption"
RETAINED_POINTS = "/silhouette/camera/retained"  # one entity below it per body part

TAKE = "/dataset/take"

HISTOGRAM = "/descriptor/histogram"
CODEBOOK = "/descriptor/codebook"
VOTES = "/descriptor/codebook/votes"
CONTEXT_SPACE = "/descriptor/space"  # the plane of two principal components of shape contexts
CONTEXT_SPACE_TRAINING = "/descriptor/space/contexts"
CONTEXT_SPACE_CENTRES = "/descriptor/space/centres"
CONTEXT_SPACE_POINTS = "/descriptor/space/points"

ESTIMATED_SKELETON = "/regression/skeleton"
ESTIMATED_POSE = "/regression/pose"
ESTIMATED_HEADING = "/regression/heading"
HEADING_NORM = "/regression/heading_norm"
ACTIVATIONS = "/regression/activations"

INFLUENTIAL_EXAMPLES = "/regression/influential_examples"
INFLUENTIAL_OUTLINES = "/regression/influential_examples/outlines"
INFLUENTIAL_SKELETONS = "/regression/influential_examples/skeletons"
INFLUENTIAL_WEIGHTS = "/regression/influential_examples/weights"

COLUMN_NORMS = "/regression/bridges/norms"
COLUMNS_LEFT = "/regression/bridges/columns_left"
OBJECTIVE = "/regression/bridges/objective"

MODES = "/regression/modes"  # below it a skeleton, a heading, a pose and a weight per mode

TRACKS = "/tracking/tracks"  # below it a skeleton, a heading and a pose per method
TRACK_NAMES = "/tracking/names"
HYPOTHESES = "/tracking/hypotheses"  # below it as below MODES, per mode of the particles
BELIEF = "/tracking/belief"
STATE = "/tracking/state"
KERNELS = "/tracking/kernels"  # one entity below it per tracker

OVERLAP = "/fitting/overlap"  # mask and fitted body's silhouette as one image
CONTOUR = "/fitting/overlap/contour"
OUTLINE = "/fitting/overlap/outline"
OUTLINE_BEFORE = "/fitting/overlap/outline_before"
FITTED_OVERLAY = "/fitting/overlap/skeleton"  # the fitted pose on the mask
OVERLAP_SHARES = "/fitting/iou"  # one entity below it per method
FITTED_SKELETON = "/fitting/skeleton"
FITTED_BODY = "/fitting/body"  # one entity below it per rigid part
FITTED_POSE = "/fitting/pose"
PATH = "/fitting/path"  # where the person is on the floor
FITTED_HEADING = "/fitting/heading"
ITERATED_OVERLAP = "/fitting/iterations/overlap"  # on the timeline `iteration`, as all below
ITERATED_CONTOUR = "/fitting/iterations/overlap/contour"
ITERATED_OUTLINE = "/fitting/iterations/overlap/outline"
ITERATED_OUTLINES = "/fitting/iterations/overlap/outlines"  # of all iterations
ITERATED_COST = "/fitting/iterations/cost"
ITERATED_IOU = "/fitting/iterations/iou"
ITERATED_SKELETON = "/fitting/iterations/skeleton"
ITERATED_TRUE_SKELETON = "/fitting/iterations/true_skeleton"

ERROR = "/evaluation/error"  # one entity below it per method
CONFIDENCE = "/evaluation/confidence"
LEG_ANGLES = "/evaluation/angles"  # one entity below it per joint and side
GAIT_PHASE = "/evaluation/phase"  # one entity below it per side

FIGURE = "/run/figure"
SETTINGS = "/run/settings"
METRICS = "/run/metrics"
LATENCY = "/run/latency"


def below(root: str, name: str) -> str:
    """Path of the entity below another that belongs to a method, a mode or a body part."""
    return f"{root}/{name.replace(' ', '_')}"  # a blank in a path would have to be escaped
