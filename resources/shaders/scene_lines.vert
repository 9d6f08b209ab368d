// Lines in the scene of constant width on screen, one instance each, drawn by line.frag. A line is two triangles; an
// arrow is three such lines, a box twelve.
uniform float ofBoxes;   // 1: from `from` to `to` along the axes
uniform float strength;  // of their opacity; below 1: where something occludes them
layout(location = 0) in vec4 from;    // w: radius, points
layout(location = 1) in vec4 to;      // w: 1 for an arrow, 2 for a line on a surface
layout(location = 2) in vec4 colour;  // sRGB and opacity
layout(location = 3) in vec4 previousOffset;  // position one step earlier minus position now
out vec2 point;
flat out vec4 lineEnds;
flat out vec4 lineColour;
flat out float lineRadius;

const vec4 kClipped = vec4(2.0, 2.0, 2.0, 1.0);
const float kBarb = 4.5;     // length of an arrow's barb / radius
const float kBias = 0.0025;  // of the distance to the eye, against z-fighting with faces

// Moves a point slightly towards the eye.
vec4 clipOf(vec3 p) {
    p += (1.0 - edges.w) * previousOffset.xyz;
    return clipFromScene * vec4(eye.w > 0.5 ? mix(p, eye.xyz, kBias) : p, 1.0);
}

// The ends of one of a box's edges: four along each axis.
void boxEdge(int edge, out vec3 a, out vec3 b) {
    int axis = edge / 4;
    vec3 high = vec3(0.0);
    high[(axis + 1) % 3] = float(edge & 1);
    high[(axis + 2) % 3] = float((edge >> 1) & 1);
    a = mix(from.xyz, to.xyz, high);
    high[axis] = 1.0;
    b = mix(from.xyz, to.xyz, high);
}

void main() {
    int part = gl_VertexID / 6, corner = gl_VertexID % 6;
    vec3 a = from.xyz, b = to.xyz;
    if (ofBoxes > 0.5) boxEdge(part, a, b);
    vec4 clipA = clipOf(a), clipB = clipOf(b);
    float insideA = clipA.z + clipA.w, insideB = clipB.z + clipB.w;  // of the near plane
    gl_Position = kClipped;
    bool isArrow = to.w > 0.5 && to.w < 1.5, isOnSurface = to.w > 1.5;
    if ((insideA <= 0.0 && insideB <= 0.0) || (part > 0 && ofBoxes < 0.5 && !isArrow)) return;
    if (isOnSurface && strength < 1.0) return;
    if (insideA <= 0.0) clipA = mix(clipA, clipB, insideA / (insideA - insideB));
    if (insideB <= 0.0) clipB = mix(clipB, clipA, insideB / (insideB - insideA));
    vec3 deviceA = clipA.xyz / clipA.w, deviceB = clipB.xyz / clipB.w;
    vec2 pixelA = (0.5 + 0.5 * deviceA.xy) * viewport.xy, pixelB = (0.5 + 0.5 * deviceB.xy) * viewport.xy;
    float extent = length(pixelB - pixelA);
    vec2 along = extent > 1e-3 ? (pixelB - pixelA) / extent : vec2(1.0, 0.0);
    lineRadius = from.w * viewport.w;
    if (part > 0 && ofBoxes < 0.5) {  // a barb, from the tip back and aside
        if (extent < 2.0 * lineRadius) return;
        float barb = min(kBarb * lineRadius, 0.5 * extent);
        vec2 aside = vec2(-along.y, along.x) * (part == 1 ? 0.45 : -0.45);
        pixelA = pixelB + barb * (aside - along);
        deviceA.z = deviceB.z;
        along = normalize(pixelB - pixelA);
    }
    vec2 across = vec2(-along.y, along.x);
    bool isAtB = corner == 1 || corner == 2 || corner == 4;
    float side = corner == 0 || corner == 1 || corner == 3 ? -1.0 : 1.0;
    float wide = lineRadius + 1.0;
    point = (isAtB ? pixelB + wide * along : pixelA - wide * along) + side * wide * across;
    lineEnds = vec4(pixelA, pixelB);
    lineColour = vec4(colour.rgb, colour.a * strength);
    gl_Position = vec4(2.0 * point / viewport.xy - 1.0, isAtB ? deviceB.z : deviceA.z, 1.0);
}
