// What all programs know of the picture that is drawn: the layout of FrameBlock in viewport/render.
// Scene: metres in the world less the scene's origin.
layout(std140) uniform Frame {
    mat4 clipFromScene;
    mat4 keyFromScene;   // to the shadow map of the key light, each in [0, 1]
    mat4 skyFromScene;   // to that of one direction of the sky
    vec4 eye;            // w: 1 in perspective, 0 where all rays are parallel
    vec4 back;           // from target to eye
    vec4 keyDirection;   // towards the light; w: its strength
    vec4 skyDirection;   // towards the one place of the sky that lights a sample
    vec4 skyLight;       // from above; w: how much light the eye itself gives
    vec4 groundLight;    // from below
    vec4 backgroundTop;  // sRGB
    vec4 backgroundBottom;
    vec4 grid;           // sRGB and opacity of its lines
    vec4 ground;         // x, y, z of its middle; w: how far the grid reaches, m
    vec4 shaded;         // least and greatest x and z of the ground that shadows reach
    vec4 spacing;        // x: m between fine lines; y: how visible they are; z: strength of shadows
    vec4 accent;         // sRGB, of what is selected
    vec4 edges;          // x: width of edges, pixels; y: their strength; z: exploded factor; w: share of the way from earlier poses to those now
    vec4 right;          // of the camera, as is the next; w: half the picture's width at a distance of 1
    vec4 up;             // w: half its height
    vec4 depth;          // x, y: third and fourth of the projection's depth; w: how bright dust is
    vec4 zenith;         // sRGB; w: 1 under a sky
    vec4 horizon;        // sRGB
    vec4 soil;           // sRGB
    vec4 picture;        // width and height, pixels; w: pixels of the display a point
    vec4 missile;        // see HeatSource, as is the next
    vec4 missileWay;
    vec4 strike;         // m/s: x: slower hits hurt nothing; y: slower ones throw nothing back
    vec4 heatRamp[6];    // sRGB of 0, 1/4, 1/2, 3/4, 1 and of what breaks
    uvec4 hovered;       // x: index of the body under the pointer, and one; 0 where there is none
};

// A square is near enough to sRGB's curve to light by, and quick where the processor draws.
vec3 linearOf(vec3 srgb) { return srgb * srgb; }
vec3 srgbOf(vec3 linear) { return sqrt(clamp(linear, 0.0, 1.0)); }
