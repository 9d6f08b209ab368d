// The light on a surface, with dark lines along its edges.
in vec3 scenePoint;
in vec3 sceneNormal;
in vec2 placeAcross;
in float edgeWidth;  // pixels, on each side of an edge
flat in vec3 colour;
flat in float opacity;
#ifdef TEXTURED
uniform sampler2D baseColour;
in vec2 placeInImage;
flat in float hasImage;
#endif

vec3 towardsEye() { return eye.w > 0.5 ? normalize(eye.xyz - scenePoint) : back.xyz; }

vec3 lit(vec3 albedo, vec3 n) {
    vec2 reached = lightReached(scenePoint, n);
    float key = max(dot(n, keyDirection.xyz), 0.0) * reached.y;
    vec3 sky = skyLight.rgb * (0.5 + 0.5 * n.y) * reached.x;
    vec3 bounce = bounceLight.rgb * (0.5 - 0.5 * n.y) * (0.35 + 0.65 * reached.x);
    return albedo * (keyLight.rgb * key + sky + bounce + vec3(skyLight.w * max(dot(n, towardsEye()), 0.0)));
}

// The linear colour of the surface without edges.
vec3 shadedSurface() {
    vec3 albedo = linearOf(colour);
#ifdef TEXTURED
    albedo *= mix(vec3(1.0), texture(baseColour, placeInImage).rgb, hasImage);
#endif
    return lit(albedo, normalize(sceneNormal));
}
const float kEdgeShade = 0.22;  // brightness of edges, of that of the surface

float edgeCover() {
    float fade = smoothstep(2.0, 12.0, pixelsAcross(placeAcross));
    return lineCover(pixelsToEdge(placeAcross), edgeWidth) * edges.y * fade;
}
