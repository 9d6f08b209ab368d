// Draws edges and a faint fill: wireframes, hulls, and the occluded parts of selected bodies.
uniform vec4 lineColour;  // sRGB and opacity
uniform vec4 fillColour;
uniform float lineWidth;  // pixels
uniform uint onlyMarks;   // 0: every body
in vec3 scenePoint;
in vec3 sceneNormal;
in vec2 placeAcross;
flat in vec3 colour;
flat in uint marks;
out vec4 pixel;

void main() {
    if (onlyMarks != 0u && (marks & onlyMarks) == 0u) discard;
    vec4 line = (marks & 2u) != 0u ? vec4(accent.rgb, max(lineColour.a, 0.6)) : lineColour;
    float cover = lineCover(pixelsToEdge(placeAcross), lineWidth) * smoothstep(1.0, 6.0, pixelsAcross(placeAcross));
    vec4 mixed = mix(fillColour, line, cover);
    if (mixed.a < 0.004) discard;
    pixel = mixed;
}
