// Light and its shadows, in three ways, since a processor that draws takes time for branches not taken, too: WITHOUT_SHADOWS;
// as a picture is drawn at once; or as one of many samples, BY_SAMPLES, lit from one place of the sky.
uniform sampler2DShadow keyShadow;
uniform sampler2DShadow skyShadow;

// How much of a light reaches a point: four places of its shadow map, each smoothed by the card.
float reached(sampler2DShadow map, vec3 place) {
    if (any(greaterThan(abs(place - 0.5), vec3(0.5)))) return 1.0;
    vec2 a = 0.75 / vec2(textureSize(map, 0)), b = vec2(a.x, -a.y);
    return 0.25 * (texture(map, vec3(place.xy + a, place.z)) + texture(map, vec3(place.xy - a, place.z)) +
                   texture(map, vec3(place.xy + b, place.z)) + texture(map, vec3(place.xy - b, place.z)));
}

#ifdef WITHOUT_SHADOWS
float keyReached(vec3 point) { return 1.0; }
#else
float keyReached(vec3 point) { return reached(keyShadow, (keyFromScene * vec4(point, 1.0)).xyz); }
#endif

// What the sky gives to a surface, and how much of its light to the ground is missing: of all of it, or of one place
// whose mean over many samples is the same but for what is hidden from it.
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
