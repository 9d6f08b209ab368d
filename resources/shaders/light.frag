// Fills the light buffer: for the solid surfaces, and the ground where there are none.
uniform sampler2D depths;
uniform sampler2D normals;
in vec2 place;
out vec4 texel;

const float kFarAway = 1e6;  // m, of the sky

const int kContactTaps = 6;
const float kContactRadius = 0.3;                   // m, of what darkens a surface
const float kLeastRadius = 4.0, kMostRadius = 40.0;  // of the same on the image, texels
const float kContactStrength = 5.0, kContactBias = 0.1, kContactLeast = 0.3;

// The view depth of what is seen at a place, whose texel is `at`.
float depthAt(ivec2 at, Sight sight) {
    float value = texelFetch(depths, at, 0).r, ofSurface = value < 1.0 ? viewDepthOf(value) : kFarAway, ofGround;
    return meetsGround(sight, ofGround) ? min(ofGround, ofSurface) : ofSurface;
}

// The part of the light from all around that near surfaces leave: taps on a spiral, each as far as it rises over the
// surface. Source: McGuire et al., "The Alchemy screen-space ambient obscurance algorithm", 2011.
float contactReached(vec3 point, vec3 n, float viewDepth, float turn) {
    vec2 size = vec2(textureSize(depths, 0));
    float perMetre = pixelsPerMetre(viewDepth) / jitter.w;
    float wide = clamp(kContactRadius * perMetre, kLeastRadius, kMostRadius), radius = wide / perMetre;
    float sum = 0.0;
    for (int k = 0; k < kContactTaps; ++k) {
        ivec2 at = ivec2(gl_FragCoord.xy + wide * discPoint(float(k), float(kContactTaps), turn));
        at = clamp(at, ivec2(0), ivec2(size) - 1);
        Sight sight = sightAt((vec2(at) + 0.5) / size);
        vec3 apart = sight.from + depthAt(at, sight) * sight.along - point;
        float square = dot(apart, apart);
        float rises = max(dot(apart, n) * inversesqrt(max(square, 1e-12)) - kContactBias, 0.0);
        sum += rises * max(1.0 - square / (radius * radius), 0.0);
    }
    return max(1.0 - kContactStrength / float(kContactTaps) * sum, kContactLeast);
}

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    vec4 surface = texelFetch(normals, at, 0);
    Sight sight = sightAt(place);
    vec3 n = vec3(0.0, 1.0, 0.0);
    float d = 0.0;
    bool isSeen = surface.a > 0.5 || meetsGround(sight, d);
    if (surface.a > 0.5) {
        n = normalize(2.0 * surface.xyz - 1.0);
        d = viewDepthOf(texelFetch(depths, at, 0).r);
    }
    vec3 point = sight.from + d * sight.along;
    float turn = fract(gradientNoise(gl_FragCoord.xy) + jitter.z);
    if (!isSeen) d = kFarAway;
    bool isFacing = dot(n, keyDirection.xyz) > 0.0;
    float sky = isSeen ? skyReached(point + skyCount.y * n, n, (at.x + at.y) & 1, turn) : 1.0;
    float key = isSeen && isFacing ? keyReachedSoftly(point + skyCount.z * n, n, turn) : isSeen ? 0.0 : 1.0;
    if (isSeen) sky *= contactReached(point, n, d, turn);
    texel = vec4(sky, key, d, surface.a > 0.5 ? packedNormal(n) : kGroundTexel);
}
