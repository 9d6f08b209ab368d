// The uniform block of all programs, with the layout of FrameBlock in viewport/render.
// Scene space: metres in the world minus the scene's origin.
layout(std140) uniform Frame {
    mat4 clipFromScene;
    mat4 keyFromScene;   // to the shadow map of the key light: texture coordinates and depth in [0, 1]
    vec4 eye;            // w: 1 in perspective, 0 in parallel projection
    vec4 back;           // from target to eye
    vec4 keyDirection;   // towards the light; w: radius of the light, of its distance
    vec4 keyLight;       // linear; w: 1 if there are transparent bodies
    vec4 skyLight[7];    // diffuse light from above, for a normal: see diffuseSky()
    vec4 groundLight;    // radiance of what is below; w: factor of the exposure
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
    vec4 depth;          // x, y: third and fourth entry of the projection's depth row
    vec4 zenith;         // radiance, as are the next two; w: 1 if there is a sky
    vec4 horizon;        // w: halvings of the glow over a right angle
    vec4 sunGlow;        // around the sun
    vec4 soil;           // of the ground in full light
    vec4 groundKey;      // the part of that which the key light gives
    vec4 viewport;       // width and height, pixels; z: pixels of 1 m at distance 1; w: device pixels per point
    vec4 jitter;         // x, y: offset of the image, pixels; z: phase of patterns; w: pixels a texel of light.glsl
    uvec4 hovered;       // x: index of the body under the pointer plus one, where it is marked; 0: none
};

// The transfer function of sRGB (IEC 61966-2-1) both ways, by fits that differ from it by less than 0.3 of 255 steps:
// powers cost more.
vec3 linearOf(vec3 srgb) {
    vec3 high = ((0.3301256 * srgb + 0.6568508) * srgb + 0.0139847) * srgb + 0.001564;
    return mix(srgb / 12.92, high, step(0.04045, srgb));
}
vec3 srgbOf(vec3 linear) {
    vec3 within = clamp(linear, 0.0, 1.0), root = sqrt(within);
    vec3 high = 0.8337568 * root + 0.2981037 * sqrt(root) - 0.055317 * within - 0.0769024;
    return mix(12.92 * within, high, step(0.0031308, within));
}

// Compresses a radiance to what a display shows: colours keep their hue.
// Source: Khronos Group, "Khronos PBR Neutral Tone Mapper", 2024.
vec3 toneMapped(vec3 radiance) {
    const float kFresnel = 0.04, kCompressed = 0.8 - kFresnel, kLeft = 1.0 - kCompressed, kDesaturation = 0.15;
    float least = max(min(radiance.r, min(radiance.g, radiance.b)), 0.0);
    float dark = min(least, 2.0 * kFresnel);
    vec3 colour = radiance - (dark - dark * dark / (4.0 * kFresnel));
    float peak = max(colour.r, max(colour.g, colour.b)), above = max(peak - kCompressed, 0.0);
    float newPeak = min(peak, kCompressed) + above * kLeft / (above + kLeft);
    float white = 1.0 - 1.0 / (kDesaturation * (peak - newPeak) + 1.0);
    return mix(colour * (newPeak / max(peak, 1e-6)), vec3(newPeak), white);
}
// The sRGB colour of a radiance.
vec3 displayed(vec3 radiance) { return srgbOf(toneMapped(groundLight.w * radiance)); }

// A pattern in [0, 1) whose neighbours differ as much as they can: any 3 x 3 pixels are spread evenly.
// Source: Jimenez, "Next Generation Post Processing in Call of Duty", 2014.
float gradientNoise(vec2 p) { return fract(52.9829189 * fract(dot(p, vec2(0.06711056, 0.00583715)))); }

// Of a surface at a view depth, the pixels of 1 m.
float pixelsPerMetre(float viewDepth) { return viewport.z / (eye.w > 0.5 ? viewDepth : 1.0); }
