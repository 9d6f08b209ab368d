// Round strokes in pixels: each an instance.
layout(location = 0) in vec4 ends;    // from and to, pixels from the lower left corner
layout(location = 1) in vec4 colour;  // sRGB and opacity
layout(location = 2) in float radius;
out vec2 point;
flat out vec4 strokeEnds;
flat out vec4 strokeColour;
flat out float strokeRadius;

void main() {
    vec2 corner = vec2((gl_VertexID & 1) != 0 ? 1.0 : 0.0, (gl_VertexID & 2) != 0 ? 1.0 : 0.0);
    float reach = radius + 1.0;
    point = mix(min(ends.xy, ends.zw) - reach, max(ends.xy, ends.zw) + reach, corner);
    strokeEnds = ends;
    strokeColour = colour;
    strokeRadius = radius;
    gl_Position = vec4(2.0 * point / picture.xy - 1.0, 0.0, 1.0);
}
