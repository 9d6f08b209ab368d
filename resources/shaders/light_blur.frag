// Smooths the light buffer within surfaces: the mean over 3 x 3 texels, whose patterns complete each other.
uniform sampler2D source;
in vec2 place;
out vec4 texel;

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy), last = textureSize(source, 0) - 1;
    vec4 here = texelFetch(source, at, 0);
    vec3 n = normalize(unpackedNormal(here.w));
    float slope = depthSlope(here.z, n, normalize(sightAt(place).along));
    vec2 sum = vec2(0.0);
    float weights = 0.0;
    for (int y = -1; y <= 1; ++y) {
        for (int x = -1; x <= 1; ++x) {
            vec4 there = texelFetch(source, clamp(at + ivec2(x, y), ivec2(0), last), 0);
            float weight = likeness(there, here.z, slope, n);
            sum += weight * there.xy;
            weights += weight;
        }
    }
    texel = vec4(sum / weights, here.zw);
}
