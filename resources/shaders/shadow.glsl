uniform sampler2DShadow keyShadow;
uniform sampler2DShadow skyShadow;

// How much of a light reaches a point: four places of its shadow map, each smoothed by the card.
float reached(sampler2DShadow map, vec3 place) {
    if (picture.z == 0.0 || any(greaterThan(abs(place - 0.5), vec3(0.5)))) return 1.0;
    vec2 a = 0.75 / vec2(textureSize(map, 0)), b = vec2(a.x, -a.y);
    return 0.25 * (texture(map, vec3(place.xy + a, place.z)) + texture(map, vec3(place.xy - a, place.z)) +
                   texture(map, vec3(place.xy + b, place.z)) + texture(map, vec3(place.xy - b, place.z)));
}
float keyReached(vec3 point) { return reached(keyShadow, (keyFromScene * vec4(point, 1.0)).xyz); }
float skyReached(vec3 point) { return reached(skyShadow, (skyFromScene * vec4(point, 1.0)).xyz); }

// What the sky gives to a surface: all of it, or one direction whose mean over many samples is the same but for what is
// hidden from it.
vec3 skyOn(vec3 n, vec3 point) {
    if (skyDirection.w == 0.0) return skyLight.rgb * (0.5 + 0.5 * n.y);
    float facing = max(dot(n, skyDirection.xyz), 0.0);
    return facing > 0.0 ? skyLight.rgb * 2.0 * facing * skyReached(point) : vec3(0.0);
}
