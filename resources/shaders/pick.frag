flat in uint body;
out uint pixel;

void main() { pixel = body; }
