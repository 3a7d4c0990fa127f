"""Claims of section II: silhouettes, descriptors and poses."""

from __future__ import annotations

from silpose.recording.paper.claims.claim import Claim
from silpose.recording.paper.found import Found

_VARIED = ("centres", "vote_width", "hellinger", "radius")


def _most_different(found: Found) -> float:
    return max(found.value(pair, "poses_apart_deg") for pair in found.methods)


def _lost(found: Found, method: str) -> float:
    return found.value(method, "gain_lost")


DESCRIPTOR = (
    Claim(
        "II-A", "Fig. 1", "Different poses can have very similar silhouettes.",
        experiment="lookalikes",
        ours=lambda f: f"poses {_most_different(f):.1f}° apart, silhouettes that overlap by 85 %",
        holds=lambda f: _most_different(f) > 5,
        agrees="Silhouettes that nearly agree belong to poses with the legs exchanged or the body "
        "turned away.",
        differs="No such pair was found among the sampled training frames.",
    ),
    Claim(
        "II-A", "Fig. 2", "Shape contexts fill a cloud that the codebook's centres cover; those of "
        "one silhouette are scattered over it.", "100 centres, 12 x 5 bins",
        experiment="descriptor_space",
        ours=lambda f: f"a silhouette votes for {f.value('codebook', 'centres_voted_for'):.0f} "
        "of the centres",
        agrees="The picture is the figure's: a dense cloud, centres all over it.",
    ),
    Claim(
        "II-A", "Fig. 3", "Silhouettes are similar where poses are; bands off the diagonal are the "
        "same phase of other steps.", "a spiral walk of 483 frames",
        experiment="similarity",
        ours=lambda f: f"rank correlation {f.value('descriptors', 'rank_correlation'):.2f}; the "
        f"nearest 1 % of silhouettes have poses among the nearest "
        f"{100 * f.value('descriptors', 'nearest_pairs'):.0f} %",
        holds=lambda f: f.value("descriptors", "nearest_pairs") < 0.1,
        agrees="Small distances of descriptors mean small distances of poses; large ones say "
        "little, as in the figure.",
        differs="Near descriptors do not mean near poses here.",
    ),
    Claim(
        "II-A", "text", "Shape contexts at regularly spaced points of the edge, within a region "
        "about as large as a limb, vote softly for the nearest of the centres.",
        reason="The number of points, the radii and the votes are not named in the paper; "
        "`silpose experiment=descriptor_choices` varies each, as the next line tells.",
    ),
    Claim(
        "II-A", "text", "Other ways to choose centres, and Hellinger distances, give similar "
        "results.", experiment="descriptor_choices",
        ours=lambda f: f"validation errors from {min(_validation(f)):.2f} to "
        f"{max(_validation(f)):.2f}°",
        holds=lambda f: max(_validation(f)) < 1.15 * min(_validation(f)),
        agrees="Among centres, votes, radii and distances the validation error changes little.",
        differs="Some choice of the descriptor matters more than the paper lets expect.",
    ),
    Claim(
        "II-A", "text", "Local descriptors survive holes, occlusion and poor segmentation, which "
        "global ones do not.", experiment="descriptor_robustness",
        ours=lambda f: f"of the gain over the mean pose, a fifth of the contour damaged costs "
        f"{100 * _lost(f, 'shape_contexts'):.0f} %; Hu moments "
        f"{100 * _lost(f, 'hu_moments'):.0f} %, aligned masks "
        f"{100 * _lost(f, 'aligned_mask_pca'):.0f} %",
        holds=lambda f: _lost(f, "shape_contexts")
        < min(_lost(f, "hu_moments"), _lost(f, "aligned_mask_pca")),
        agrees="Histograms of shape contexts lose least.",
        differs="Another descriptor loses less here.",
    ),
    Claim(
        "II-B", "text", "55 numbers: 54 angles of 18 joints, with the heading as (cos, sin).",
        "54 + 1", experiment="single_image",
        agrees="The pose vector is the paper's; which joints turn was not published in full.",
    ),
    Claim(
        "II-B", "data", "Silhouettes rendered with POSER from motion capture.",
        reason="The rendered silhouettes were not published, and the site of the motion capture is "
        "gone: silhouettes are rendered here, of walkers or of your own motion capture.",
    ),
    Claim(
        "II-B", "data", "The original 54 angles.",
        reason="The authors' file holds joint positions: errors on it are distances, a body "
        "measuring about 65.",
    ),
)  # fmt: skip


def _validation(found: Found) -> list[float]:
    return [float(row["validation_error"]) for row in found.rows() if row.get("validation_error")]
