// Chips, lit as bodies are.
in vec3 scenePoint;
flat in vec3 faceNormal;
flat in vec3 chipColour;  // linear
flat in float roughness;
out vec4 pixel;

void main() {
    vec3 toEye = eye.w > 0.5 ? normalize(eye.xyz - scenePoint) : back.xyz;
    vec3 n = dot(faceNormal, toEye) < 0.0 ? -faceNormal : faceNormal;
    Surface surface = Surface(chipColour, n, roughness, 0.0, 0.8);
    pixel = vec4(displayed(lit(surface, toEye, lightReached(scenePoint, n))), 1.0);
}
