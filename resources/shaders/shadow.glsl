// Lights and shadows. Three variants, since a software rasterizer pays for branches that are not taken:
// WITHOUT_SHADOWS; one pass; and BY_SAMPLES, for one of many samples, each lit from one point of the sky.
uniform sampler2DShadow keyShadow;
uniform sampler2DShadow skyShadow;

// The visibility of a light from a point: four bilinear samples of its shadow map. The map holds all bodies, so that a
// point beside it is lit, and one behind all of them is compared with the nearest body on the way.
float reached(sampler2DShadow map, vec3 place) {
    if (any(greaterThan(abs(place.xy - 0.5), vec2(0.5)))) return 1.0;
    place.z = clamp(place.z, 0.0, 1.0);
    vec2 a = 0.75 / vec2(textureSize(map, 0)), b = vec2(a.x, -a.y);
    return 0.25 * (texture(map, vec3(place.xy + a, place.z)) + texture(map, vec3(place.xy - a, place.z)) +
                   texture(map, vec3(place.xy + b, place.z)) + texture(map, vec3(place.xy - b, place.z)));
}

#ifdef WITHOUT_SHADOWS
float keyReached(vec3 point) { return 1.0; }
#else
float keyReached(vec3 point) { return reached(keyShadow, (keyFromScene * vec4(point, 1.0)).xyz); }
#endif

// The sky light on a surface, and its part that is missing on the ground: of the whole sky, or of one point of it,
// whose mean over many samples is the same where nothing is occluded.
#ifdef BY_SAMPLES
float skyReached(vec3 point) { return reached(skyShadow, (skyFromScene * vec4(point, 1.0)).xyz); }
vec3 skyOn(vec3 n, vec3 point) {
    float facing = max(dot(n, skyDirection.xyz), 0.0);
    return facing > 0.0 ? skyLight.rgb * 2.0 * facing * skyReached(point) : vec3(0.0);
}
float skyMissing(vec3 point) { return 2.0 * skyDirection.y * (1.0 - skyReached(point)); }
#else
vec3 skyOn(vec3 n, vec3 point) { return skyLight.rgb * (0.5 + 0.5 * n.y); }
float skyMissing(vec3 point) { return 0.0; }
#endif
