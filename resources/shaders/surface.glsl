// The light on a surface, with dark lines along its edges.
in vec3 scenePoint;
in vec3 sceneNormal;
in vec2 placeAcross;
flat in vec3 colour;
flat in float opacity;
flat in uint marks;

vec3 towardsEye() { return eye.w > 0.5 ? normalize(eye.xyz - scenePoint) : back.xyz; }

vec3 lit(vec3 albedo, vec3 n) {
    float key = max(dot(n, keyDirection.xyz), 0.0);
    if (key > 0.0) key *= keyReached(scenePoint);
    vec3 light = skyOn(n, scenePoint) + groundLight.rgb * (0.5 - 0.5 * n.y) + vec3(keyDirection.w * key) +
                 vec3(skyLight.w * max(dot(n, towardsEye()), 0.0));
    return albedo * light;
}

// The linear colour of the surface without edges.
vec3 shadedSurface() {
    vec3 albedo = linearOf(colour);
    if ((marks & 4u) != 0u) albedo = mix(albedo, vec3(1.0), 0.25);  // under the pointer
    return lit(albedo, normalize(sceneNormal));
}
const float kEdgeShade = 0.22;  // brightness of edges, of that of the surface

float edgeCover() {
    float fade = smoothstep(2.0, 12.0, pixelsAcross(placeAcross));
    return lineCover(pixelsToEdge(placeAcross), edges.x) * edges.y * fade;
}
