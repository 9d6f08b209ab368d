in vec3 scenePoint;
in vec3 sceneNormal;
in vec2 placeAcross;
flat in vec3 colour;
flat in uint marks;
out vec4 pixel;

vec3 lit(vec3 albedo, vec3 n) {
    vec3 towardsEye = eye.w > 0.5 ? normalize(eye.xyz - scenePoint) : back.xyz;
    float key = max(dot(n, keyDirection.xyz), 0.0);
    if (key > 0.0) key *= keyReached(scenePoint);
    vec3 light = skyOn(n, scenePoint) + groundLight.rgb * (0.5 - 0.5 * n.y) + vec3(keyDirection.w * key) +
                 vec3(skyLight.w * max(dot(n, towardsEye), 0.0));
    return albedo * light;
}

void main() {
    vec3 normal = normalize(sceneNormal);
    vec3 albedo = linearOf(colour);
    if ((marks & 4u) != 0u) albedo = mix(albedo, vec3(1.0), 0.25);  // under the pointer
    vec3 shaded = lit(albedo, normal);

    float pixels = pixelsToEdge(placeAcross);
    float fade = smoothstep(2.0, 12.0, pixelsAcross(placeAcross));
    float cover = lineCover(pixels, edges.x) * edges.y * fade;
    pixel = vec4(srgbOf(mix(shaded, shaded * 0.22, cover)), 1.0);
}
