// Selects the variant of a program that draws batches without finishes.
