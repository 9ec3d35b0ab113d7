// SPDX-License-Identifier: Apache-2.0
/// The points at distance `tube` from a circle of radius `radius` around the origin in the plane y = 0, both
/// > 0; a transform puts it anywhere else. Its normal points outward.
struct Torus {
    double radius = 1, tube = 0.25;
    template <class Self, class Visit> static void fields(Self& self, Visit&& visit) {
        visit.length("radius", self.radius);
        visit.length("tube", self.tube);
    }
};
