"""From bytes to numbers, a file a format: bytes in any cutting, and no broken frame taken for a good one."""
