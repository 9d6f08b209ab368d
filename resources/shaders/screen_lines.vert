// Lines with round caps in pixels, one instance each.
layout(location = 0) in vec4 ends;    // from and to, pixels from the lower left corner
layout(location = 1) in vec4 colour;  // sRGB and opacity
layout(location = 2) in float radius;
out vec2 point;
flat out vec4 lineEnds;
flat out vec4 lineColour;
flat out float lineRadius;

void main() {
    vec2 corner = vec2((gl_VertexID & 1) != 0 ? 1.0 : 0.0, (gl_VertexID & 2) != 0 ? 1.0 : 0.0);
    float margin = radius + 1.0;
    point = mix(min(ends.xy, ends.zw) - margin, max(ends.xy, ends.zw) + margin, corner);
    lineEnds = ends;
    lineColour = colour;
    lineRadius = radius;
    gl_Position = vec4(2.0 * point / viewport.xy - 1.0, 0.0, 1.0);
}
