"""The MkDocs theme of an Armillary site; its files ask nothing of the network."""
