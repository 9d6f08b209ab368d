// The shadow map of the key light.
uniform sampler2DShadow keyShadow;
uniform sampler2D keyDepths;             // the same depths, to be read
uniform sampler2D keyGlass;              // what transparent bodies leave of the light
uniform sampler2DShadow keyGlassShadow;  // the depths of the nearest of them

const int kBlockerTaps = 6, kShadowTaps = 12;
const float kWidestSearch = 0.02;  // of the map
const float kSteepest = 6.0;       // slope of a surface, seen by the light

// A point in the shadow map: texture coordinates and depth. The map holds all bodies, so that a point beside it is lit,
// and one behind all of them is compared with the nearest body on the way.
vec3 keyPlace(vec3 point) {
    vec3 at = (keyFromScene * vec4(point, 1.0)).xyz;
    return vec3(at.xy, clamp(at.z, 0.0, 1.0));
}
bool isInMap(vec3 at) { return all(lessThanEqual(abs(at.xy - 0.5), vec2(0.5))); }

// The light that transparent bodies before a point leave.
float glassPassed(vec3 at) {
    if (keyLight.w < 0.5) return 1.0;
    vec4 passed = texture(keyGlass, at.xy);
    return mix(min(passed.r, passed.a), 1.0, texture(keyGlassShadow, at));
}

// The visibility of the light's centre: four bilinear samples.
float keyReached(vec3 point) {
    vec3 at = keyPlace(point);
    if (!isInMap(at)) return 1.0;
    vec2 a = 0.75 / vec2(textureSize(keyShadow, 0)), b = vec2(a.x, -a.y);
    float lit = 0.25 * (texture(keyShadow, vec3(at.xy + a, at.z)) + texture(keyShadow, vec3(at.xy - a, at.z)) +
                        texture(keyShadow, vec3(at.xy + b, at.z)) + texture(keyShadow, vec3(at.xy - b, at.z)));
    return lit * glassPassed(at);
}

// Point `k` of `count` that are spread evenly over a disc. Source: Vogel, "A better way to construct the sunflower
// head", 1979.
vec2 discPoint(float k, float count, float turn) {
    float angle = 2.39996323 * k + 6.2831853 * turn;
    return sqrt((k + 0.5) / count) * vec2(cos(angle), sin(angle));
}

// The part of an area light that is visible from a surface with normal n: the mean distance of what is before it gives
// the width of the shadow's edge. `turn` in [0, 1) rotates the samples. Source: Fernando, "Percentage-Closer Soft
// Shadows", 2005.
float keyReachedSoftly(vec3 point, vec3 n, float turn) {
    vec3 at = keyPlace(point);
    if (!isInMap(at)) return 1.0;
    float texel = 1.0 / float(textureSize(keyDepths, 0).x);
    float search = max(min(keyDirection.w * at.z, kWidestSearch), 2.0 * texel);
    vec3 facing = mat3(keyFromScene) * n;  // towards the light: z < 0
    vec2 slope = clamp(facing.xy / max(-facing.z, 1e-6), -kSteepest, kSteepest);  // of the surface's depth in the map
    float before = 0.0, count = 0.0;
    for (int k = 0; k <= kBlockerTaps; ++k) {  // the last one at the centre, for what is narrower than the disc
        vec2 offset = k < kBlockerTaps ? search * discPoint(float(k), float(kBlockerTaps), turn) : vec2(0.0);
        float nearest = texture(keyDepths, at.xy + offset).r;
        float isBefore = step(nearest + texel, min(at.z + dot(slope, offset), 1.0));
        before += isBefore * nearest;
        count += isBefore;
    }
    if (count < 0.5) return glassPassed(at);
    float radius = clamp(keyDirection.w * (at.z - before / count), texel, search);
    float lit = 0.0;
    for (int k = 0; k < kShadowTaps; ++k) {
        vec2 offset = radius * discPoint(float(k), float(kShadowTaps), turn);
        lit += texture(keyShadow, vec3(at.xy + offset, min(at.z + dot(slope, offset), 1.0)));
    }
    return lit / float(kShadowTaps) * glassPassed(at);
}
