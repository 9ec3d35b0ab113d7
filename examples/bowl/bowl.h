// SPDX-License-Identifier: Apache-2.0
/// A paraboloid around the y axis: y = height (x^2 + z^2) / radius^2, from its lowest point, the origin, up
/// to the height, both > 0; a transform puts it anywhere else. It is open above. Its normal points away from
/// the axis, and down.
struct Bowl {
    double radius = 1, height = 1;
    template <class Self, class Visit> static void fields(Self& self, Visit&& visit) {
        visit.length("radius", self.radius);
        visit.length("height", self.height);
    }
};
