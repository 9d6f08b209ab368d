// Shadows on the ground.
in vec3 scenePoint;
out vec4 pixel;

void main() {
    float key = keyDirection.w * max(keyDirection.y, 0.0);
    float sky = dot(skyLight.rgb, vec3(1.0 / 3.0));
    float missing = (key * (1.0 - keyReached(scenePoint)) + sky * skyMissing(scenePoint)) / (key + sky);
    pixel = vec4(0.0, 0.0, 0.0, spacing.z * min(missing, 1.0));
}
