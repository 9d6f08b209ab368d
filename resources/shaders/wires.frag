// Draws edges and a faint fill: wireframes and hulls.
uniform vec4 lineColour;  // sRGB and opacity
uniform vec4 fillColour;
uniform float lineWidth;  // pixels
in vec3 scenePoint;
in vec3 sceneNormal;
in vec2 placeAcross;
flat in vec3 colour;
out vec4 pixel;

void main() {
    float cover = lineCover(pixelsToEdge(placeAcross), lineWidth) * smoothstep(1.0, 6.0, pixelsAcross(placeAcross));
    vec4 mixed = mix(fillColour, lineColour, cover);
    if (mixed.a < 0.004) discard;
    pixel = mixed;
}
