// The light on a surface, with dark lines along its edges.
const float kRoughness = 0.8;  // of what has no material of its own

vec3 towardsEye() { return eye.w > 0.5 ? normalize(eye.xyz - scenePoint) : back.xyz; }

// The material at the pixel.
Surface surfaceHere() {
    vec3 albedo = colour;
#ifdef TEXTURED
    albedo *= mix(vec3(1.0), texture(baseColour, placeInImage).rgb, hasImage);
#endif
    return bevelled(finished(Surface(albedo, normalize(sceneNormal), kRoughness, 0.0, 1.0)));
}

// The radiance of the surface without edges.
vec3 shadedSurface(Surface surface) {
    return lit(surface, towardsEye(), lightReached(scenePoint, surface.normal));
}

float edgeCover() {
    float fade = smoothstep(2.0, 12.0, pixelsAcross(placeAcross));
    return lineCover(pixelsToEdge(placeAcross), edgeWidth) * edges.y * fade;
}
