// How much of the sky reaches a surface: by shadow maps of many of its directions.
layout(std140) uniform Sky {
    mat4 skyFromScene[32];   // to texture coordinates and depth in [0, 1]
    vec4 skyDirections[32];  // towards the sky
    vec4 skyCount;           // x: how many there are
};
uniform sampler2DArrayShadow skyShadows;

const float kSoftness = 3.5;  // texels, by which the edges of shadows are blurred

// The part of the sky's light on a surface with normal n that is not occluded: by each second direction, from `first`
// (0 or 1) on. `turn` in [0, 1) spreads the samples.
float skyReached(vec3 point, vec3 n, int first, float turn) {
    vec2 aside = kSoftness / float(textureSize(skyShadows, 0).x) * vec2(cos(6.2831853 * turn), sin(6.2831853 * turn));
    float whole = 0.0, reached = 0.0;
    for (int k = first; k < int(skyCount.x); k += 2) {
        float facing = dot(n, skyDirections[k].xyz);
        if (facing <= 0.0) continue;
        aside = vec2(-0.7373688 * aside.x - 0.6754903 * aside.y, 0.6754903 * aside.x - 0.7373688 * aside.y);
        vec3 at = (skyFromScene[k] * vec4(point, 1.0)).xyz;
        bool isInside = all(lessThanEqual(abs(at.xy - 0.5), vec2(0.5)));
        vec2 spread = at.xy + sqrt(fract(turn + 0.618034 * float(k))) * aside;
        whole += facing;
        reached += facing * (isInside ? texture(skyShadows, vec4(spread, float(k), min(at.z, 1.0))) : 1.0);
    }
    return whole > 0.0 ? reached / whole : 1.0;
}
