// What a chip keeps from the ground below it: a blot on the ground where its shadow falls.
out vec2 corner;
flat out float darkness;

const float kLargest = 6.0;  // radii over the ground: above, no shadow is seen
const float kWide = 1.15;  // radii of the blot when it lies, and more the higher it is

void main() {
    int number = gl_VertexID % 6;
    corner = vec2(number == 1 || number == 2 || number == 4 ? 1.0 : -1.0,
                  number == 0 || number == 1 || number == 3 ? -1.0 : 1.0);
    vec3 at = chipCentre();
    float height = max(at.y - ground.y, 0.0), radii = height / max(centre.w, 1e-4);
    bool isSeen = spacing.z > 0.5 && radii < kLargest;
    darkness = (int(colour.w) == 1 ? 0.15 : 0.36) * (1.0 - radii / kLargest);
    vec2 aside = -keyDirection.xz * min(height / max(keyDirection.y, 0.2), 3.0 * centre.w);
    vec2 place = at.xz + aside + corner * centre.w * (kWide + 0.25 * radii);
    gl_Position = isSeen ? clipFromScene * vec4(place.x, ground.y, place.y, 1.0) : vec4(2.0, 2.0, 2.0, 1.0);
}
