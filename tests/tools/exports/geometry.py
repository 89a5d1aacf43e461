"""Cameras as OpenCV's documentation defines them, and whether two frames show one world."""

import numpy

Z_UP = numpy.array([[1.0, 0, 0, 0], [0, 0, -1, 0], [0, 1, 0, 0], [0, 0, 0, 1]])  # of a world with y up


def distort(lens, x, y):
    """Where the lens `lens`, a dict of a model and its coefficients, images the direction (x, y, 1)."""
    k = lambda name: lens.get(name, 0.0)
    r2 = x * x + y * y
    if lens["model"] == "fisheye":
        r = numpy.sqrt(r2)
        angle = numpy.arctan(r)
        a2 = angle * angle
        scale = angle * (1 + a2 * (k("k1") + a2 * (k("k2") + a2 * (k("k3") + a2 * k("k4"))))) / numpy.maximum(r, 1e-12)
        return scale * x, scale * y
    radial = (1 + r2 * (k("k1") + r2 * (k("k2") + r2 * k("k3")))) / (1 + r2 * (k("k4") + r2 * (k("k5") + r2 * k("k6"))))
    return (radial * x + 2 * k("p1") * x * y + k("p2") * (r2 + 2 * x * x),
            radial * y + k("p1") * (r2 + 2 * y * y) + 2 * k("p2") * x * y)


def undistort(lens, xd, yd):
    """The inverse, by fixed points with the error fed back."""
    x, y = xd.copy(), yd.copy()
    for _ in range(100):
        u, v = distort(lens, x, y)
        x, y = x + (xd - u), y + (yd - v)
    return x, y


class View:
    """A frame: grey image, depth in m (0 is none), T_world_camera with x right, y down, z forward, and the
    camera, whose pixel (0, 0) is the centre of the first."""

    def __init__(self, image, depth, T_world_camera, focal, centre, lens):
        self.grey = image.astype(float).mean(axis=2) if image.ndim == 3 else image.astype(float)
        self.depth, self.T = depth.astype(float), T_world_camera
        self.focal, self.centre, self.lens = focal, centre, lens

    def points(self):
        """World points of the pixels that have depth, and their grey."""
        v, u = numpy.nonzero(self.depth > 0)
        x, y = undistort(self.lens, (u - self.centre[0]) / self.focal[0], (v - self.centre[1]) / self.focal[1])
        z = self.depth[v, u]
        camera = numpy.stack([x * z, y * z, z, numpy.ones_like(z)])
        return self.T @ camera, self.grey[v, u]

    def project(self, world):
        """Pixels and depth of world points."""
        x, y, z, _ = numpy.linalg.inv(self.T) @ world
        with numpy.errstate(divide="ignore", invalid="ignore"):
            xd, yd = distort(self.lens, x / z, y / z)
        return self.focal[0] * xd + self.centre[0], self.focal[1] * yd + self.centre[1], z


def agreement(a, b):
    """Of the pixels of `a` that `b` sees: the share whose depth agrees within 1 %, and of those the median
    difference of grey where a bilinear `b` is compared."""
    world, grey = a.points()
    u, v, z = b.project(world)
    height, width = b.depth.shape
    inside = (z > 0) & (u >= 0) & (v >= 0) & (u <= width - 1.001) & (v <= height - 1.001)
    assert inside.sum() > 0.2 * inside.size, f"only {inside.sum()} of {inside.size} pixels are seen by the other frame"
    u, v, z, grey = u[inside], v[inside], z[inside], grey[inside]
    seen = b.depth[numpy.rint(v).astype(int), numpy.rint(u).astype(int)]
    agrees = numpy.abs(seen - z) < 0.01 * z
    i, j = numpy.floor(v).astype(int), numpy.floor(u).astype(int)
    s, t = u - j, v - i
    imaged = ((1 - t) * ((1 - s) * b.grey[i, j] + s * b.grey[i, j + 1]) +
              t * ((1 - s) * b.grey[i + 1, j] + s * b.grey[i + 1, j + 1]))
    return agrees.mean(), numpy.median(numpy.abs(imaged - grey)[agrees])


def require_agreement(a, b, what):
    share, difference = agreement(a, b)
    print(f"{what}: {100 * share:.1f} % of the pixels seen have the depth of the other frame within 1 %, "
          f"median difference of grey {difference:.2f} of 255")
    assert share > 0.88, f"{what}: depth agrees in {share:.3f} of the pixels"
    assert difference < 6, f"{what}: grey differs by {difference:.2f}"
