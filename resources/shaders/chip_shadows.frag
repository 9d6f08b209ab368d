in vec2 corner;
flat in float darkness;
out vec4 pixel;

void main() {
    float near = max(1.0 - dot(corner, corner), 0.0);
    pixel = vec4(vec3(0.0), darkness * smoothstep(0.0, 1.0, near));
}
