// The uniform block of all programs, with the layout of FrameBlock in viewport/render.
// Scene space: metres in the world minus the scene's origin.
layout(std140) uniform Frame {
    mat4 clipFromScene;
    mat4 keyFromScene;   // to the shadow map of the key light: texture coordinates and depth in [0, 1]
    mat4 skyFromScene;   // to the shadow map of one sky direction
    vec4 eye;            // w: 1 in perspective, 0 in parallel projection
    vec4 back;           // from target to eye
    vec4 keyDirection;   // towards the light; w: its intensity
    vec4 skyDirection;   // towards the point of the sky that lights a sample
    vec4 skyLight;       // from above; w: intensity of the headlight
    vec4 groundLight;    // from below
    vec4 backgroundTop;  // sRGB
    vec4 backgroundBottom;
    vec4 grid;           // sRGB and opacity of its lines
    vec4 ground;         // x, y, z of its centre; w: radius of the grid, m
    vec4 shaded;         // min and max x and z of the ground that shadows can reach
    vec4 spacing;        // x: m between fine lines; y: their opacity; z: strength of shadows
    vec4 accent;         // sRGB, of selected bodies
    vec4 edges;          // x: width of edges, pixels; y: their opacity; z: explode factor; w: step fraction
    vec4 right;          // of the camera, as is the next; w: half the image's width at distance 1
    vec4 up;             // w: half its height
    vec4 depth;          // x, y: third and fourth entry of the projection's depth row; w: brightness of dust
    vec4 zenith;         // sRGB; w: 1 if there is a sky
    vec4 horizon;        // sRGB
    vec4 soil;           // sRGB
    vec4 viewport;        // width and height, pixels; w: device pixels per point
    uvec4 hovered;       // x: index of the body under the pointer plus one; 0: none
};

// Approximates sRGB's transfer function by a square: accurate enough for lighting, and fast in software.
vec3 linearOf(vec3 srgb) { return srgb * srgb; }
vec3 srgbOf(vec3 linear) { return sqrt(clamp(linear, 0.0, 1.0)); }
