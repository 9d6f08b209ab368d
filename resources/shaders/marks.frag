// Marks on a body: half the factor of its brightness, so that marks can also brighten it. An impact chips a shallow bowl
// off the surface, whose slopes face other parts of the sky; soot darkens what is near a blast.
uniform vec4 markCentres[8];  // in the frame of the solid; w: radius, m
uniform vec4 markNormals[8];  // 0: soot; w: seed
uniform uint markCount;
in vec3 localPoint;
in vec3 localNormal;
flat in vec4 orientation;
out vec4 pixel;

const float kSteepness = 0.9;  // of the bowl's slope at its rim
const float kDeep = 0.5;       // radii, by which a marked surface may be before or behind the mark's plane

vec3 rotatedBy(vec4 q, vec3 v) { return v + 2.0 * cross(q.xyz, cross(q.xyz, v) + q.w * v); }

float random(vec3 p) { return fract(sin(dot(p, vec3(12.9898, 78.233, 37.719))) * 43758.5453); }
float noise(vec3 p) {
    vec3 cell = floor(p), part = smoothstep(0.0, 1.0, fract(p));
    vec2 at = vec2(0.0, 1.0);
    vec4 low = vec4(random(cell + at.xxx), random(cell + at.yxx), random(cell + at.xyx), random(cell + at.yyx));
    vec4 high = vec4(random(cell + at.xxy), random(cell + at.yxy), random(cell + at.xyy), random(cell + at.yyy));
    vec4 between = mix(low, high, part.z);
    vec2 row = mix(between.xz, between.yw, part.x);
    return mix(row.x, row.y, part.y);
}

float brightness(vec3 n) {
    vec3 light = diffuseSky(n) + 0.5 * (1.0 - n.y) * groundLight.rgb +
                 0.5 * max(dot(n, keyDirection.xyz), 0.0) * keyLight.rgb;
    return dot(light, vec3(0.3, 0.6, 0.1));
}

float soot(vec3 apart, float seed) {
    float radial = length(apart), blots = noise(6.0 * apart + 31.0 * seed);
    return 1.0 - 0.8 * (1.0 - smoothstep(0.2, 0.65 + 0.35 * blots, radial));
}

// The factor of a bowl, with an irregular rim.
float bowl(vec3 apart, vec3 outwards, float seed, vec3 n) {
    float deep = dot(apart, outwards);
    vec3 aside = apart - deep * outwards;
    float blots = noise(5.0 * aside + 31.0 * seed), fine = noise(13.0 * aside + 17.0 * seed);
    float radial = length(aside) / (0.55 + 0.45 * blots);
    if (abs(deep) > kDeep || dot(n, outwards) < 0.5 || radial >= 1.0) return 1.0;
    vec3 rough = 0.5 * (fine - 0.5) * outwards.yzx;
    vec3 sloped = normalize(n - kSteepness * radial * aside / max(length(aside), 1e-4) + rough);
    float factor = brightness(rotatedBy(orientation, sloped)) / max(brightness(rotatedBy(orientation, n)), 1e-4);
    float rim = 1.0 - 0.35 * smoothstep(0.7, 0.95, radial), fresh = 1.12 - 0.3 * fine;
    return mix(1.0, clamp(sqrt(factor) * rim * fresh, 0.35, 1.6), 1.0 - smoothstep(0.85, 1.0, radial));
}

void main() {
    vec3 n = normalize(localNormal);
    float factor = 1.0;
    for (uint k = 0u; k < markCount; ++k) {
        vec3 apart = (localPoint - markCentres[k].xyz) / markCentres[k].w;
        if (dot(apart, apart) >= 1.0) continue;
        bool isSoot = markNormals[k].xyz == vec3(0.0);
        factor *= isSoot ? soot(apart, markNormals[k].w) : bowl(apart, markNormals[k].xyz, markNormals[k].w, n);
    }
    if (factor == 1.0) discard;  // a half is no step of 8 bits
    pixel = vec4(vec3(0.5 * min(factor, 2.0)), 1.0);
}
