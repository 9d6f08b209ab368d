// Selects the variant of a program that draws batches with finishes.
#define FINISHED
