// What the sky gives: see Sky in viewport/render/light.
uniform sampler3D reflections;  // a layer for each roughness: see ReflectionMap

const float kReflectionTexels = 64.0, kReflectionLayers = 6.0;

// The diffuse light from above on a surface with normal n, if nothing occludes it: nine spherical harmonics.
// Source: Sloan, "Stupid spherical harmonics tricks", 2008, for the order of the terms.
vec3 diffuseSky(vec3 n) {
    vec4 linear = vec4(n, 1.0), products = n.xyzz * n.yzzx;
    vec3 sum = vec3(dot(skyLight[0], linear), dot(skyLight[1], linear), dot(skyLight[2], linear)) +
               vec3(dot(skyLight[3], products), dot(skyLight[4], products), dot(skyLight[5], products)) +
               skyLight[6].rgb * (n.x * n.x - n.y * n.y);
    return max(sum, 0.0);
}

// The radiance around a direction, in the mean over the lobe of a roughness.
vec3 reflected(vec3 direction, float roughness) {
    vec3 p = direction / (abs(direction.x) + abs(direction.y) + abs(direction.z));
    vec2 folded = (1.0 - abs(p.zx)) * vec2(p.x < 0.0 ? -1.0 : 1.0, p.z < 0.0 ? -1.0 : 1.0);
    vec2 square = p.y < 0.0 ? folded : p.xz;
    vec2 place = (0.5 * kReflectionTexels * (square + 1.0) + 1.0) / (kReflectionTexels + 2.0);
    float layer = (roughness * (kReflectionLayers - 1.0) + 0.5) / kReflectionLayers;
    return texture(reflections, vec3(place, layer)).rgb;
}
