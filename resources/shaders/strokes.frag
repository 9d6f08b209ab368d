in vec2 point;
flat in vec4 strokeEnds;
flat in vec4 strokeColour;
flat in float strokeRadius;
out vec4 pixel;

void main() {
    vec2 along = strokeEnds.zw - strokeEnds.xy, to = point - strokeEnds.xy;
    float share = clamp(dot(to, along) / max(dot(along, along), 1e-6), 0.0, 1.0);
    float distance = length(to - share * along) - strokeRadius;
    pixel = vec4(strokeColour.rgb, strokeColour.a * (1.0 - smoothstep(-0.5, 0.5, distance)));
}
