"""The MkDocs theme of an Armillary site: templates, styles and scripts that ask nothing of the network."""
