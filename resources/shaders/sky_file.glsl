// The sky behind a scene, from a file, in place of background.glsl.
uniform sampler2D skyFile;  // see placeInSky()

// A ground fades into the horizon, not into what the file has below it.
vec3 skyRadiance(vec3 along) {
    vec2 place = vec2(0.5 + atan(along.x, -along.z) / 6.2831853, atan(length(along.xz), along.y) / 3.1415927);
    float lowest = 0.5 - 0.5 / float(textureSize(skyFile, 0).y);
    if (spacing.z > 0.5) place.y = min(place.y, lowest);
    return textureLod(skyFile, place, 0.0).rgb;
}
