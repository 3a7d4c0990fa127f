"""From descriptors z to poses x: bases, ridge and relevance vector regression."""
