// What a surface of a transparent body leaves of the light: in red to be multiplied by that of others, in alpha for the
// least of all.
flat in vec2 passed;
out vec4 pixel;

void main() { pixel = vec4(passed.xxx, passed.y); }
