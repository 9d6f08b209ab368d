// What a transparent body leaves of the light, to be multiplied by that of others.
flat in float passed;
out vec4 pixel;

void main() { pixel = vec4(passed); }
