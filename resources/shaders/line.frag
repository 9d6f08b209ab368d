in vec2 point;
flat in vec4 lineEnds;
flat in vec4 lineColour;
flat in float lineRadius;
out vec4 pixel;

void main() {
    vec2 along = lineEnds.zw - lineEnds.xy, to = point - lineEnds.xy;
    float t = clamp(dot(to, along) / max(dot(along, along), 1e-6), 0.0, 1.0);
    float distance = length(to - t * along) - lineRadius;
    pixel = vec4(lineColour.rgb, lineColour.a * (1.0 - smoothstep(-0.5, 0.5, distance)));
}
