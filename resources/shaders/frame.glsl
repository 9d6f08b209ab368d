// The uniform block of all programs, with the layout of FrameBlock in viewport/render.
// Scene space: metres in the world minus the scene's origin.
layout(std140) uniform Frame {
    mat4 clipFromScene;
    mat4 keyFromScene;   // to the shadow map of the key light: texture coordinates and depth in [0, 1]
    vec4 eye;            // w: 1 in perspective, 0 in parallel projection
    vec4 back;           // from target to eye
    vec4 keyDirection;   // towards the light; w: radius of the light, of its distance
    vec4 keyLight;       // linear, as are the next two
    vec4 skyLight;       // from above; w: intensity of the headlight
    vec4 bounceLight;    // from below
    vec4 backgroundTop;  // sRGB
    vec4 backgroundBottom;
    vec4 grid;           // sRGB and opacity of its lines
    vec4 ground;         // x, y, z of its centre; w: radius of the grid, m
    vec4 spacing;        // x: m between fine lines; y: their opacity; z: 1 if there is a ground, w: a grid on it
    vec4 gridOrigin;     // x, z: of the scene, modulo the grid's step
    vec4 accent;         // sRGB, of selected bodies
    vec4 edges;          // x: pixels a point; y: opacity of edges; z: explode factor; w: step fraction
    vec4 right;          // of the camera, as is the next; w: half the image's width at distance 1
    vec4 up;             // w: half its height
    vec4 depth;          // x, y: third and fourth entry of the projection's depth row; w: brightness of dust
    vec4 zenith;         // sRGB; w: 1 if there is a sky
    vec4 horizon;        // sRGB
    vec4 soil;           // sRGB, of the ground in full light
    vec4 viewport;       // width and height, pixels; z: pixels of 1 m at distance 1; w: device pixels per point
    vec4 jitter;         // x, y: offset of the image, pixels; z: phase of patterns; w: pixels a texel of light.glsl
    uvec4 hovered;       // x: index of the body under the pointer plus one, where it is marked; 0: none
};

// Approximates sRGB's transfer function by a square: accurate enough for lighting, and fast in software.
vec3 linearOf(vec3 srgb) { return srgb * srgb; }
vec3 srgbOf(vec3 linear) { return sqrt(clamp(linear, 0.0, 1.0)); }

// A pattern in [0, 1) whose neighbours differ as much as they can: any 3 x 3 pixels are spread evenly.
// Source: Jimenez, "Next Generation Post Processing in Call of Duty", 2014.
float gradientNoise(vec2 p) { return fract(52.9829189 * fract(dot(p, vec2(0.06711056, 0.00583715)))); }

// Of a surface at a view depth, the pixels of 1 m.
float pixelsPerMetre(float viewDepth) { return viewport.z / (eye.w > 0.5 ? viewDepth : 1.0); }
