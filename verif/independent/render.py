# SPDX-License-Identifier: Apache-2.0
"""render.py: a renderer of 3D Gaussians in numpy, written from INRIA's semantics.

It shares nothing with the C++ of this project, so that an error in one is not an error in the other. Everything is
computed in double precision, Gaussian by Gaussian instead of tile by tile; the picture is a float32 PFM (bottom row
first), black behind. Each rule is one of graphdeco-inria/diff-gaussian-rasterization at 59f5f77 and names its place
there: F is cuda_rasterizer/forward.cu, A auxiliary.h, R rasterizer_impl.cu, then the line. Quaternions have length one
before (F127 takes them as they come). Antialiased scenes (a comment of their header) have the opacity of
preprocessCUDA in that file at 077706fe. A principal point off the centre, which INRIA's cameras have not, moves means.

render(..., whole=True) is what machines promise instead, where that differs: a Gaussian counts wherever its alpha is
1/255, not only in tiles that three sigma touch; there is no 1e-7 beside w; depths are compared in double.
"""
import numpy as np

C1 = 0.4886025119029199
C2 = (1.0925484305920792, -1.0925484305920792, 0.31539156525252005, -1.0925484305920792, 0.5462742152960396)
C3 = (-0.5900435899266435, 2.890611442640554, -0.4570457994644658, 0.3731763325901154)
C3 += (-0.4570457994644658, 1.445305721320277, -0.5900435899266435)


class Scene:
    def __init__(self, path):
        head, _, body = open(path, "rb").read().partition(b"end_header\n")
        lines = head.decode().split("\n")
        names = [line.split()[2] for line in lines if line.startswith("property float ")]
        table = np.frombuffer(body, "<f4").reshape(-1, len(names)).astype(np.float64)
        field = lambda *wanted: np.stack([table[:, names.index(name)] for name in wanted], 1)
        self.antialiased = "comment antialiased 1" in lines
        self.means, self.sigmas = field("x", "y", "z"), np.exp(field("scale_0", "scale_1", "scale_2"))
        self.turns = field("rot_0", "rot_1", "rot_2", "rot_3")
        self.opacities = 1 / (1 + np.exp(-field("opacity")[:, 0]))
        rest = [name for name in names if name.startswith("f_rest_")]  # by channel: all of red, green, blue
        self.sh = field("f_dc_0", "f_dc_1", "f_dc_2")[:, None]
        if rest:
            by_channel = field(*[f"f_rest_{i}" for i in range(len(rest))]).reshape(len(table), 3, -1)
            self.sh = np.concatenate([self.sh, by_channel.transpose(0, 2, 1)], 1)


def colour(sh, d):  # F20-71; sh: 1, 4, 9 or 16 coefficients by 3 channels
    x, y, z = d
    basis = [0.28209479177387814, -C1 * y, C1 * z, -C1 * x]
    basis += [C2[0] * x * y, C2[1] * y * z, C2[2] * (2 * z * z - x * x - y * y), C2[3] * x * z]
    basis += [C2[4] * (x * x - y * y), C3[0] * y * (3 * x * x - y * y), C3[1] * x * y * z]
    basis += [C3[2] * y * (4 * z * z - x * x - y * y), C3[3] * z * (2 * z * z - 3 * x * x - 3 * y * y)]
    basis += [C3[4] * x * (4 * z * z - x * x - y * y), C3[5] * z * (x * x - y * y), C3[6] * x * (x * x - 3 * y * y)]
    return np.maximum(np.array(basis[: len(sh)]) @ sh + 0.5, 0)


def rotation(q):  # F134-138
    w, x, y, z = q / np.linalg.norm(q)
    return np.array([
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ])  # fmt: skip


class Lens:
    """One axis of the camera: pixels of the picture, focal length, principal point; 0 is the first pixel's centre."""

    def __init__(self, pixels, focal, centre):
        self.pixels, self.focal, self.tan = pixels, focal, pixels / (2 * focal)  # R222-223
        self.off_centre = centre - (pixels - 1) / 2

    def mean(self, x, z, epsilon):  # F198-200, A43
        return ((x / self.tan / (z + epsilon) + 1) * self.pixels - 1) / 2 + self.off_centre

    def guarded(self, x, z):  # F82-87
        return np.clip(x / z, -1.3 * self.tan, 1.3 * self.tan) * z

    def tiles(self, u, radius):  # A48-55: pixels of the first tile's begin and the last one's end; as C, to zero
        return max(0, int((u - radius) / 16)) * 16, max(0, int((u + radius + 15) / 16)) * 16


def render(scene, camera, whole=False):
    """RGB, and T, the sum of weight times depth, the number of Gaussians blended: twice height by width by three."""
    width, height = camera["width"], camera["height"]
    across = Lens(width, camera["fx"], camera.get("cx", (width - 1) / 2))
    down = Lens(height, camera["fy"], camera.get("cy", (height - 1) / 2))
    to_view, centre = np.array(camera["rotation"]).T, np.array(camera["position"])
    views = (scene.means - centre) @ to_view.T
    row, column = np.mgrid[0:height, 0:width]
    image, through, depth = np.zeros((height, width, 3)), np.ones((height, width)), np.zeros((height, width))
    stopped, blended = np.zeros((height, width), bool), np.zeros((height, width))
    depths = views[:, 2] if whole else views[:, 2].astype(np.float32)  # R104
    for i in np.argsort(depths, kind="stable"):  # equal depth: by index (R303)
        x, y, z = views[i]
        if z <= 0.2:  # A154
            continue
        u, v = (lens.mean(at, z, 0 if whole else 1e-7) for lens, at in ((across, x), (down, y)))
        jacobian = np.array([  # F89-92
            [across.focal / z, 0, -across.focal * across.guarded(x, z) / z**2],
            [0, down.focal / z, -down.focal * down.guarded(y, z) / z**2],
        ])  # fmt: skip
        half = jacobian @ to_view @ rotation(scene.turns[i]) * scene.sigmas[i]  # F140-143, F106
        (a, b), (_, c) = half @ half.T
        sharp = a * c - b * b
        a, c = a + 0.3, c + 0.3  # F110-111
        det = a * c - b * b
        opacity = scene.opacities[i] * (np.sqrt(max(0.000025, sharp / det)) if scene.antialiased else 1)
        power = -(c * (u - column) ** 2 + a * (v - row) ** 2) / (2 * det) + b * (u - column) * (v - row) / det  # F335
        alpha = np.minimum(0.99, opacity * np.exp(np.minimum(power, 0)))  # F343
        seen = (power <= 0) & (alpha >= 1 / 255) & ~stopped  # F336, F344
        if not whole:
            middle = (a + c) / 2
            radius = np.ceil(3 * np.sqrt(middle + np.sqrt(max(0.1, middle * middle - det))))  # F229-232
            (left, right), (top, bottom) = across.tiles(u, radius), down.tiles(v, radius)
            seen &= (column >= left) & (column < right) & (row >= top) & (row < bottom)
        stops = seen & (through * (1 - alpha) < 1e-4)  # F347-351: whoever ends a pixel is not blended
        stopped |= stops
        seen &= ~stops
        direction = (scene.means[i] - centre) / np.linalg.norm(scene.means[i] - centre)
        weight = np.where(seen, through * alpha, 0)
        image += weight[:, :, None] * colour(scene.sh[i], direction)  # F355
        depth += weight * z
        blended += seen
        through -= weight
    return image, np.stack([through, depth, blended], 2)


def write_pfm(path, picture):
    with open(path, "wb") as out:
        out.write(b"PF\n%d %d\n-1.0\n" % (picture.shape[1], picture.shape[0]))
        out.write(picture[::-1].astype("<f4").tobytes())
